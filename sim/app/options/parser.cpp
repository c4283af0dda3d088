// Implements option declarations with the library CLI11.
#include "sim/app/options/parser.hpp"

#include <optional>
#include <vector>

#include <CLI/CLI.hpp>

namespace rayclock {

Declared& Declared::required() {
    option_->required();
    return *this;
}
Declared& Declared::with_default() {
    option_->capture_default_str();
    return *this;
}
Declared& Declared::within(int least, int most) {
    option_->check(CLI::Range(least, most));
    return *this;
}
Declared& Declared::by_commas() {
    option_->delimiter(',');
    return *this;
}
Declared& Declared::or_alone(const char* implied) {
    option_->expected(0, 1)->default_str(implied);
    return *this;
}
Declared& Declared::one_each() {
    option_->allow_extra_args(false);
    return *this;
}
Declared& Declared::under(const char* heading) {
    option_->group(heading);
    return *this;
}
Declared& Declared::excludes(const Declared& other) {
    option_->excludes(other.option_);
    return *this;
}

template <class Value> Declared Parser::option(const char* names, Value& value, const char* help) {
    return Declared(app_.add_option(names, value, help));
}
Declared Parser::flag(const char* names, bool& value, const char* help) {
    return Declared(app_.add_flag(names, value, help));
}

template Declared Parser::option(const char*, std::string&, const char*);
template Declared Parser::option(const char*, std::vector<std::string>&, const char*);
template Declared Parser::option(const char*, int&, const char*);
template Declared Parser::option(const char*, std::uint64_t&, const char*);
template Declared Parser::option(const char*, double&, const char*);
template Declared Parser::option(const char*, std::optional<std::string>&, const char*);
template Declared Parser::option(const char*, std::optional<int>&, const char*);
template Declared Parser::option(const char*, std::optional<double>&, const char*);

}   // namespace rayclock
