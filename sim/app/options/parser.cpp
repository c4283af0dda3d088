// Implements option declarations with the library CLI11.
#include "sim/app/options/parser.hpp"

#include <optional>
#include <vector>

#include <CLI/CLI.hpp>

namespace rayclock {

DeclaredOption& DeclaredOption::required() {
    option_->required();
    return *this;
}
DeclaredOption& DeclaredOption::with_default() {
    option_->capture_default_str();
    return *this;
}
DeclaredOption& DeclaredOption::within(int least, int most) {
    option_->check(CLI::Range(least, most));
    return *this;
}
DeclaredOption& DeclaredOption::by_commas() {
    option_->delimiter(',');
    return *this;
}
DeclaredOption& DeclaredOption::or_alone(const char* implied) {
    option_->expected(0, 1)->default_str(implied);
    return *this;
}
DeclaredOption& DeclaredOption::one_each() {
    option_->allow_extra_args(false);
    return *this;
}
DeclaredOption& DeclaredOption::under(const char* heading) {
    option_->group(heading);
    return *this;
}
DeclaredOption& DeclaredOption::excludes(const DeclaredOption& other) {
    option_->excludes(other.option_);
    return *this;
}

template <class Value> DeclaredOption Parser::option(const char* names, Value& value, const char* help) {
    return DeclaredOption(app_.add_option(names, value, help));
}
DeclaredOption Parser::flag(const char* names, bool& value, const char* help) {
    return DeclaredOption(app_.add_flag(names, value, help));
}

template DeclaredOption Parser::option(const char*, std::string&, const char*);
template DeclaredOption Parser::option(const char*, std::vector<std::string>&, const char*);
template DeclaredOption Parser::option(const char*, int&, const char*);
template DeclaredOption Parser::option(const char*, std::uint64_t&, const char*);
template DeclaredOption Parser::option(const char*, double&, const char*);
template DeclaredOption Parser::option(const char*, std::optional<std::string>&, const char*);
template DeclaredOption Parser::option(const char*, std::optional<int>&, const char*);
template DeclaredOption Parser::option(const char*, std::optional<double>&, const char*);

}   // namespace rayclock
