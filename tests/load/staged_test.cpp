// Files that are published together, and what may be read afterwards.
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>

#include <unistd.h>

#include "model/base/error.hpp"
#include "sim/files/folder.hpp"
#include "sim/files/input.hpp"
#include "sim/files/output.hpp"
#include "sim/files/scratch.hpp"
#include "tests/support/files/test_folder.hpp"

using namespace rayclock;
namespace fs = std::filesystem;

TEST_CASE("a published file replaces the old one, which may be read again under another name") {
    const test::TestFolder folder;   // not on the list that signal handlers remove
    const fs::path old = folder.path() / "x.png", kept = folder.path() / "kept.png";
    std::ofstream(old) << "old";
    fs::create_hard_link(old, kept);
    const std::string typed = (folder.path() / "." / "x.png").string();   // not as the folder names it
    check_writable(typed);
    CHECK_THROWS_AS(read_file(kept), UserError);   // it is the file that would be replaced
    StagedFiles staged(folder.path().string() + "/");
    std::ofstream(staged.stage() / "x.png") << "new";
    staged.publish();
    CHECK(read_file(old) == "new");
    CHECK(read_file(kept) == "old");
    fs::rename(kept, old);   // the old file under its old name: the announcement would fit it again
    CHECK(read_file(old) == "old");
}

TEST_CASE("a stale input entry protects no output") {
    const test::TestFolder folder;   // not on the list that signal handlers remove
    const fs::path input = folder.path() / "a.json", output = folder.path() / "b.json";
    std::ofstream(input) << "{}";
    CHECK(read_file(input) == "{}");
    CHECK_THROWS_AS(check_writable(input), UserError);
    // A rename keeps the inode. The system may reuse the inode of a removed file in the same way.
    fs::rename(input, output);
    CHECK_NOTHROW(check_writable(output));
}

TEST_CASE("a signal after files are published removes none of them, and one before removes them all") {
    const test::TestFolder folder;   // not on the list that signal handlers remove
    const fs::path out = folder.path() / "out", exported = folder.path() / "exported";
    StagedFiles staged(out.string());
    std::ofstream(staged.stage() / "x.png") << "new";
    staged.publish();
    NewFolder whole(exported.string());
    whole.write("a/b.sv", "module");
    whole.publish();
    StagedFiles early(out.string());
    std::ofstream(early.stage() / "y.png") << "new";
    NewFolder part((folder.path() / "part").string());
    part.write("c.sv", "module");
    remove_scratch();   // what the handler does
    CHECK(!fs::exists(early.stage()));
    CHECK(fs::exists(out / "x.png"));
    CHECK(fs::exists(exported / "a" / "b.sv"));
    CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 2);
}
