// Collects the text, files and numbers of a page of figures.
#include "sim/study/figures/figures_page.hpp"

#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/files/image/image.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock::figures {

namespace fs = std::filesystem;

Page::Page(const Studio& studio, std::string folder) : studio_(studio), folder_(std::move(folder)) {
    std::error_code error;
    fs::create_directories(fs::path(folder_) / "figures", error);
    if (error || !fs::is_directory(fs::path(folder_) / "figures"))
        throw UserError(folder_ + ": cannot be made a folder for the figures");
    check_writable((fs::path(folder_) / "figures" / "page.png").string());
}

void Page::table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows) {
    Table table(head);
    for (const auto& row : rows) table.add(row);
    text_ += "\n" + table.markdown() + "\n";
}

std::string Page::picture(const std::string& name, const Picture& picture) {
    write_picture((fs::path(folder_) / "figures" / (name + ".png")).string(), picture,
                  {picture.size, std::vector<Hit>(picture.pixels.size())});
    return fmt::format("![{0}](figures/{0}.png)", name);
}

std::string Page::plot(const std::string& name, const plot::Drawing& drawing) {
    write_file((fs::path(folder_) / "figures" / (name + ".svg")).string(), plot::svg(drawing));
    return fmt::format("![{0}](figures/{0}.svg)", name);
}

std::vector<std::pair<Tracer, Shot>> Page::shots(Stage& stage, const std::string& what,
                                                 const Whitted& settings) {
    std::vector<std::pair<Tracer, Shot>> all;
    for (const Tracer tracer : {Tracer::reference, Tracer::model})
        if (studio_.has(tracer)) all.emplace_back(tracer, stage.take(tracer, settings));
    if (!studio_.has(Tracer::rtl) || !rtl_trouble_.empty()) return all;
    try {
        all.emplace_back(Tracer::rtl, stage.take(Tracer::rtl, settings));
    } catch (const UserError& e) {
        if (interrupted() || all.empty()) throw;   // only the RTL was requested
        rtl_trouble_ = e.what();
        return all;
    }
    ++rtl_pictures_;
    if (!studio_.has(Tracer::model)) return all;
    const Shot &model = all[all.size() - 2].second, &rtl = all.back().second;
    if (model.run->colours != rtl.run->colours || model.run->cycles != rtl.run->cycles)
        throw std::runtime_error(fmt::format(
            "{}: the RTL's picture is not the model's: {} cycles and {}, colours {}", what, rtl.run->cycles,
            model.run->cycles, model.run->colours == rtl.run->colours ? "equal" : "not equal"));
    ++rtl_compared_;
    return all;
}

std::vector<Tracer> Page::measured() const {
    std::vector<Tracer> all;
    for (const Tracer tracer : studio_.tracers)
        if (tracer != Tracer::rtl || (!studio_.has(Tracer::model) && rtl_trouble_.empty()))
            all.push_back(tracer);
    return all;
}

std::string Page::rtl_sentence() const {
    if (!studio_.has(Tracer::rtl)) return "The RTL was not requested.";
    if (!rtl_trouble_.empty()) return "The RTL was left out: " + rtl_trouble_ + ".";
    if (rtl_compared_ == 0) return fmt::format("The RTL drew {} pictures.", rtl_pictures_);
    return fmt::format(
        "The RTL drew {} of these pictures too. The command compared each with the model's: colours and "
        "cycles are equal, bit for bit, so the page shows them once.",
        rtl_compared_);
}

std::string per_cent(double share) { return fmt::format("{:.1f} %", 100 * share); }
std::string decibels(double psnr_db) {
    return std::isfinite(psnr_db) ? fmt::format("{:.1f}", psnr_db) : "equal";
}

}   // namespace rayclock::figures
