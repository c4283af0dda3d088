#include "sim/load/importer.hpp"

#include <algorithm>
#include <cstring>

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/ProgressHandler.hpp>

#include "sim/load/text.hpp"

namespace rayclock {
namespace {

class MemoryStream : public Assimp::IOStream {
public:
    explicit MemoryStream(const std::string& bytes) : bytes_(bytes) {}
    std::size_t Read(void* to, std::size_t size, std::size_t count) override {
        if (size == 0) return 0;
        count = std::min(count, (bytes_.size() - at_) / size);
        std::memcpy(to, bytes_.data() + at_, size * count);
        at_ += size * count;
        return count;
    }
    std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
    aiReturn Seek(std::size_t offset, aiOrigin origin) override {
        const std::size_t base = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? at_ : bytes_.size();
        if (offset > bytes_.size() - std::min(base, bytes_.size())) return aiReturn_FAILURE;
        at_ = base + offset;
        return aiReturn_SUCCESS;
    }
    std::size_t Tell() const override { return at_; }
    std::size_t FileSize() const override { return bytes_.size(); }
    void Flush() override {}

private:
    const std::string& bytes_;
    std::size_t at_ = 0;
};

/// The prepared files and nothing else, whatever folder is put in front of their names.
class MemoryFiles : public Assimp::IOSystem {
public:
    explicit MemoryFiles(const Prepared& prepared) : prepared_(prepared) {}
    bool Exists(const char* name) const override { return find(name) != nullptr; }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char*) override {
        const std::string* bytes = find(name);
        return bytes != nullptr ? new MemoryStream(*bytes) : nullptr;
    }
    void Close(Assimp::IOStream* stream) override { delete stream; }

private:
    const std::string* find(std::string_view name) const {
        const auto found = prepared_.files.find(std::string(name.substr(name.rfind('/') + 1)));
        return found == prepared_.files.end() ? nullptr : &found->second;
    }
    const Prepared& prepared_;
};

class Reporter : public Assimp::ProgressHandler {
public:
    explicit Reporter(const Progress& progress) : progress_(progress) {}
    bool Update(float fraction) override {
        if (progress_ && fraction >= 0 && fraction <= 1) progress_("importing", static_cast<std::uint64_t>(fraction * 1000), 1000);
        return true;
    }

private:
    const Progress& progress_;
};

} // namespace

Imported import_files(const std::string& file, const Prepared& prepared, const Progress& progress) {
    Imported result{std::make_unique<Assimp::Importer>()};
    // Both are owned by the importer. They may outlive what they refer to: after reading they are only deleted.
    result.importer->SetIOHandler(new MemoryFiles(prepared));
    result.importer->SetProgressHandler(new Reporter(progress));
    std::string reason;
    try {
        result.scene = result.importer->ReadFile(prepared.main, 0);
        if (result.scene == nullptr) reason = result.importer->GetErrorString();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        reason = error.what();
    }
    if (result.scene == nullptr) Place{file}.refuse("the importer gave up (" + reason + ")");
    return result;
}

} // namespace rayclock
