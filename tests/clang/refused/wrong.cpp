// Refused by every compiler: the control of clang_reads_the_model.
int wrong() { return "text"; }
