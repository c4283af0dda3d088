#pragma once
// Pictures of COLLADA files, with the samplers that read them.
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <glm/vec3.hpp>

#include "model/scene/texture.hpp"
#include "sim/load/dae/document.hpp"
#include "sim/load/textures.hpp"

namespace rayclock {

/// The parameters of an effect: by the name of a <newparam>, the element with its value.
using DaeParams = std::map<std::string, const XmlElement*>;

/// The pictures that <texture> elements show. The references are texture -> sampler2D -> surface -> image,
/// and in COLLADA 1.5 texture -> sampler2D -> image. Many programs name the image directly. A picture that
/// cannot be found or read only causes a note.
class DaeTextures {
public:
    /// `folder` is the folder of the document.
    DaeTextures(DaeDocument& document, std::filesystem::path folder)
        : document_(document),
          folder_(std::move(folder)),
          files_(document.file(), "document", document.loading()),
          warnings_(document.file()) {}

    /// Returns the index of a <texture> in all(). Returns nothing if the load averages textures or the
    /// picture cannot be read. Throws UserError if the sampler is wrong.
    std::optional<std::uint32_t> texture(const XmlElement& in, const DaeParams& params);
    /// Returns the average colour of a <texture> in linear light. Returns nothing if the load draws textures
    /// or the picture cannot be read.
    std::optional<glm::vec3> average(const XmlElement& in, const DaeParams& params);
    const std::vector<Texture>& all() const { return all_; }
    /// Adds notes to the loading about everything that was left out.
    void say_left_out() const { warnings_.say(document_.loading()); }

private:
    /// A picture's file, or nothing, and the <sampler2D>, which may be null.
    struct Source {
        std::optional<std::string> file;
        const XmlElement* sampler = nullptr;
    };
    Source source(const XmlElement& in, const DaeParams& params);
    std::optional<std::string> file_of(const XmlElement& image);
    Wrap wrap(const XmlElement& sampler, const char* name);
    void sample(const XmlElement& sampler, Texture& out);

    /// The file, the wrap modes, and the flags `nearest` and `mipmaps`.
    using Key = std::tuple<std::string, Wrap, Wrap, bool, bool>;

    DaeDocument& document_;
    std::filesystem::path folder_;
    PictureFiles files_;
    Warnings warnings_;
    std::vector<Texture> all_;
    std::map<Key, std::uint32_t> numbers_;
};

}   // namespace rayclock
