// Opens pages in a browser without a window, and reads their data.
#include "tests/cli/view/browser.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <sstream>

namespace rayclock::test {

nlohmann::json data_of(const std::string& page, const std::string& id) {
    const std::string head = "<script type=\"application/json\" id=\"" + id + "\">";
    const std::size_t begin = page.find(head);
    REQUIRE(begin != page.npos);
    const std::size_t end = page.find("</script>", begin);
    return nlohmann::json::parse(page.substr(begin + head.size(), end - begin - head.size()));
}

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t n = 0;
    for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++n;
    return n;
}

bool is_installed(const std::string& program) {
    return std::system(("PATH=$PATH:/usr/sbin command -v " + program + " > /dev/null 2>&1").c_str()) == 0;
}

std::string shown(const TestFolder& folder, const std::string& page, const std::string& script) {
    const std::string file = folder.write(
        "shown.html",
        page + "<script>async function tested() {\n" + script +
            "\n}\nconst poll = setInterval(async () => { if (!document.body.dataset.shown) return;\n"
            "clearInterval(poll); document.title = 'answer ' + await tested(); }, 50);</script>");
    if (!is_installed("chromium")) {
        WARN("chromium is not installed");
        return {};
    }
    const std::string command = "chromium --headless=new --no-sandbox --disable-gpu --user-data-dir='" +
                                folder.name("profile") +
                                "' --enable-logging=stderr --virtual-time-budget=20000 --dump-dom 'file://" +
                                file + "' > '" + folder.name("dom") + "' 2> '" + folder.name("log") + "'";
    CHECK(std::system(command.c_str()) == 0);
    const std::string log = content_of(folder.name("log"));
    INFO(log);
    CHECK(log.find("CONSOLE") == log.npos);
    const std::string dom = content_of(folder.name("dom")), head = "<title>answer ";
    const std::size_t begin = dom.find(head);
    REQUIRE(begin != dom.npos);
    return dom.substr(begin + head.size(), dom.find("</title>") - begin - head.size());
}

PageTimes time_to_open(const TestFolder& folder, const std::string& page) {
    const std::string word = "opened after ";
    const std::string file = folder.write(
        "opened.html", page +
                           "<script>const poll = setInterval(() => { const at = name => "
                           "performance.getEntriesByName(name)[0];\n"
                           "if (!at('shown')) return; clearInterval(poll); console.info('" +
                           word +
                           "' + at('opened').startTime + ' ' + at('shown').startTime); }, 50);</script>");
    const std::string log = folder.name("opened.log");
    const std::string command =
        "chromium --headless=new --no-sandbox --disable-gpu --user-data-dir='" + folder.name("profile") +
        "' --enable-logging=stderr  'file://" + file + "' > /dev/null 2> '" + log +
        "' & browser=$!; for i in $(seq 300); do grep -q '" + word + "' '" + log +
        "' && break; sleep 0.1; done; kill $browser; wait $browser 2> /dev/null; true";
    CHECK(std::system(command.c_str()) == 0);
    const std::string said = content_of(log);
    INFO(said);
    const std::size_t at = said.find(word);
    REQUIRE(at != said.npos);
    std::istringstream numbers(said.substr(at + word.size()));
    PageTimes times{};
    REQUIRE((numbers >> times.opened >> times.whole));
    return times;
}

void check_alone(const std::string& page) {
    CHECK(count(page, "<html") == 1);
    CHECK(count(page, "<table") == count(page, "</table>"));
    CHECK(count(page, "<tr>") > 10);
    for (const char* link : {"src=\"http", "href=\"http", "url(http", "@import", "<link rel=\"stylesheet"})
        CHECK(page.find(link) == page.npos);
}

}   // namespace rayclock::test
