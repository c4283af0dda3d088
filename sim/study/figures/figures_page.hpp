#pragma once
// A page of figures under construction: Markdown, pictures in a folder next to it, and all numbers as JSON.
#include <nlohmann/json.hpp>

#include "sim/study/figures/studio.hpp"
#include "sim/view/plot/chart.hpp"

namespace rayclock::figures {

/// The distance between two pictures, over linear colours of all pixels and channels.
struct Distance {
    double rmse = 0;      ///< root of the mean square; full scale is 1
    double mean = 0;      ///< mean of the absolute difference; full scale is 1
    double psnr_db = 0;   ///< of 8-bit sRGB values, as elsewhere in this program; infinite for equal pictures
};
Distance distance(const Picture& a, const Picture& b);
/// Returns |a - b| times `factor`, clamped to 1.
Picture amplified_difference(const Picture& a, const Picture& b, double factor);
/// Returns the mean of all pixels and channels.
double mean_of(const Picture& picture);
/// Returns w x h pixels from (x, y), each enlarged to `factor` x `factor`.
Picture magnified(const Picture& picture, int x, int y, int w, int h, int factor);

/// Collects a page. Each figure appends its section, files and numbers.
class Page {
public:
    /// Pictures go to folder/figures. Throws UserError if the folder cannot be written.
    Page(const Studio& studio, std::string folder);

    const Studio& studio() const { return studio_; }
    void say(const std::string& markdown) { text_ += markdown; }
    /// Appends a table with a heading row. All columns except the first are numbers.
    void table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows);
    /// Writes folder/figures/NAME.png and returns the Markdown that shows it.
    std::string picture(const std::string& name, const Picture& picture);
    /// Writes folder/figures/NAME.svg and returns the Markdown that shows it.
    std::string plot(const std::string& name, const plot::Drawing& drawing);

    /// Renders a picture with each requested tracer. The RTL's picture and cycles must equal the model's;
    /// otherwise throws std::runtime_error that names the picture. Omits the RTL if it was not requested or
    /// cannot be built.
    std::vector<std::pair<Tracer, Shot>> shots(Stage& stage, const std::string& what,
                                               const Whitted& settings);
    /// Returns the tracers that are measured for curves. The RTL is omitted if the model is present, because
    /// its cycles and colours are the same.
    std::vector<Tracer> measured() const;
    /// Returns the outcome of the RTL as a sentence for the page.
    std::string rtl_sentence() const;

    nlohmann::ordered_json numbers = nlohmann::ordered_json::object();
    const std::string& text() const { return text_; }
    /// Returns true if a tracer has its own pictures and rows. The RTL's equal the model's.
    bool is_shown(Tracer tracer) const { return tracer != Tracer::rtl || !studio_.has(Tracer::model); }

private:
    Studio studio_;
    std::string folder_, text_, rtl_trouble_;
    int rtl_pictures_ = 0, rtl_compared_ = 0;
};

/// Formats for the last columns of most tables of the page.
std::string per_cent(double share);     ///< 0.123 -> "12.3 %"
std::string decibels(double psnr_db);   ///< "41.2", or "equal"

// The figures in the order of the page. Each appends its section and its numbers.
void bounces(Page& page);         ///< spheres at depth 0..5
void endless_plane(Page& page);   ///< without and with anti-aliasing
void edge(Page& page);            ///< with regular and jittered samples
void test_share(Page& page);      ///< share of time in intersection tests
void cutoffs(Page& page);         ///< depth and threshold: speed against error
void adaptive(Page& page);        ///< samples where they are needed

/// Returns the whole page. `command` is the command that makes it.
std::string make_page(Page& page, const std::string& command);

}   // namespace rayclock::figures
