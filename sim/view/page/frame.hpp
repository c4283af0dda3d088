#pragma once
// The frame that all pages share: head, style, Vega and scripts.
#include <string>

namespace rayclock {

// Contents of the style and script files in this folder. CMake embeds them in the program.
extern const char* const page_viewer;
extern const char* const page_charts;
extern const char* const page_machine;
extern const char* const page_sweep;
extern const char* const page_compare;
extern const char* const page_explain;

struct FramedPage {
    std::string title;     ///< plain text
    std::string header;    ///< under the title
    std::string body;      ///< sections
    std::string data;      ///< script elements with JSON; one has the id `data`
    std::string scripts;   ///< the page's own scripts, which run after the shared ones
    bool trees = false;    ///< includes Vega's tree layouts
    std::string far{};     ///< result of far_from_reference(), or empty: the page's first line
};
/// Returns the page as one HTML file. Throws UserError if the chart library is not installed.
std::string framed(const FramedPage& page);

/// Throws UserError if the chart library is missing, so that a command can fail before it starts its work.
void check_page_library();

}   // namespace rayclock
