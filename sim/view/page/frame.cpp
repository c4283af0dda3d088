// Assembles a page: head, style, Vega, body, data and scripts.
#include "sim/view/page/frame.hpp"

#include <fmt/format.h>

#include "sim/view/page/html.hpp"
#include "sim/view/page/library.hpp"

namespace rayclock {

extern const char* const page_style;
extern const char* const page_common;

std::string framed(const FramedPage& page) {
    const std::string title = html::escaped(page.title);
    std::string out = "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\">\n<title>" + title +
                      "</title>\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                      "<link rel=\"icon\" href=\"data:,\">\n<style>\n" +
                      page_style + "</style></head>\n<body>\n<header>" +
                      (page.far.empty() ? "" : "<p class=\"far\">" + html::escaped(page.far) + "</p>\n") +
                      "<h1>" + title + "</h1>\n" + page.header +
                      "</header>\n<noscript><p class=\"note\">Without scripts this page has its pictures and "
                      "tables, and no "
                      "charts.</p></noscript>\n<main>\n" +
                      page.body + "</main>\n" + page.data + "<script>\nconst vegaModules = {};\n";
    for (const LibraryModule& module : chart_library(page.trees))
        out += fmt::format("vegaModules[\"{}\"] = function(exports, module, require, define) {{{}\n}};\n",
                           module.name, module.source);
    return out + "</script>\n<script>\n" + page_common + page.scripts + "</script>\n</body></html>\n";
}

void check_page_library() { chart_library(true); }

}   // namespace rayclock
