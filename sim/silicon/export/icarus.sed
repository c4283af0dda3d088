# Changes the sources for Icarus Verilog 11. It does not read `int unsigned` in a localparam, a type of a package by its
# full name, nor an $error that refuses parameters. Its always_comb starts anew whatever a function in it computes, and
# never ends.
s/\bint unsigned\b/[31:0]/
s/rc_pkg::\([a-z0-9_]*_t\)\b/\1/g
s/\balways_comb\b/always @*/
/^endpackage/a import rc_pkg::*;
/^ *if (.*) begin : gen_refuse/,/^ *end$/d
