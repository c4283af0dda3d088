#pragma once
// A page of figures while it is made: Markdown, the pictures beside it, and all numbers as JSON.
#include <nlohmann/json.hpp>

#include "sim/study/figures/studio.hpp"
#include "sim/view/plot/chart.hpp"

namespace rayclock::figures {

/// How far a picture is from another: linear colours, all pixels and channels.
struct Distance {
    double rmse = 0;      ///< root of the mean square, in 1 of full scale
    double mean = 0;      ///< mean of the absolute difference, likewise
    double psnr_db = 0;   ///< of 8-bit sRGB values, as elsewhere in this program; infinite if they are equal
};
Distance distance(const Picture& a, const Picture& b);
/// |a - b| times `factor`, cut at 1.
Picture amplified_difference(const Picture& a, const Picture& b, double factor);
/// Mean of all pixels and channels.
double mean_of(const Picture& picture);
/// w x h pixels from (x, y) on, each as a square of `factor` x `factor`.
Picture magnified(const Picture& picture, int x, int y, int w, int h, int factor);

class Page {
public:
    /// Pictures go to folder/figures. Throws UserError if they could not.
    Page(const Studio& studio, std::string folder);

    const Studio& studio() const { return studio_; }
    void say(const std::string& markdown) { text_ += markdown; }
    /// A table: heads, then rows; all columns but the first are numbers.
    void table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows);
    /// Writes folder/figures/NAME.png and gives the Markdown that shows it.
    std::string picture(const std::string& name, const Picture& picture);
    /// The same with NAME.svg.
    std::string plot(const std::string& name, const plot::Drawing& drawing);

    /// The picture of this name by each engine that was asked for. The RTL's must be the model's, bit for bit
    /// and in as many cycles; if it is not, UserError names it. Without the RTL, or if it cannot be built, it
    /// is left out.
    std::vector<std::pair<Engine, Shot>> shots(Stage& stage, const std::string& what,
                                               const Whitted& settings);
    /// Those by which curves are measured: not the RTL if the model is there, for its cycles and colours are
    /// the same.
    std::vector<Engine> measured() const;
    /// What became of the RTL, as a sentence for the page.
    std::string rtl_sentence() const;

    nlohmann::ordered_json numbers = nlohmann::ordered_json::object();
    const std::string& text() const { return text_; }
    /// Whether an engine has pictures and rows of its own: the RTL's are the model's.
    bool is_shown(Engine e) const { return e != Engine::rtl || !studio_.has(Engine::model); }

private:
    Studio studio_;
    std::string folder_, text_, rtl_trouble_;
    int rtl_pictures_ = 0, rtl_compared_ = 0;
};

/// Columns that most tables of the page end with.
std::string per_cent(double share);     ///< 0.123 -> "12.3 %"
std::string decibels(double psnr_db);   ///< "41.2", or "equal"

// The figures, in the order of the page. Each appends its section and its numbers.
void bounces(Page& page);         ///< spheres at depth 0..5
void endless_plane(Page& page);   ///< without and with anti-aliasing
void edge(Page& page);            ///< regular and jittered
void test_share(Page& page);      ///< time in intersection tests
void cutoffs(Page& page);         ///< depth and threshold: speed against error
void adaptive(Page& page);        ///< samples only where they are needed

/// The whole page; `command` is what to type for it.
std::string make_page(Page& page, const std::string& command);

}   // namespace rayclock::figures
