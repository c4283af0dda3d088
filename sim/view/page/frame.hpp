#pragma once
// What all pages have around their sections: head, style, Vega and scripts.
#include <string>

namespace rayclock {

// Of the files beside this one; CMake makes them part of the program.
extern const char* const page_viewer;
extern const char* const page_charts;
extern const char* const page_machine;
extern const char* const page_sweep;
extern const char* const page_compare;
extern const char* const page_explain;

struct FramedPage {
    std::string title;     ///< as text
    std::string header;    ///< under the title
    std::string body;      ///< sections
    std::string data;      ///< script elements with JSON; one is called data
    std::string scripts;   ///< what draws, after what all pages share
    bool trees = false;    ///< with Vega's trees
    std::string far{};     ///< far_from_reference(): the page's first line, or empty
};
/// One HTML file. Throws UserError if the library that draws its charts is not installed.
std::string framed(const FramedPage& page);

/// Fails early (UserError) if the library is missing.
void check_page_library();

}   // namespace rayclock
