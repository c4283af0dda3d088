// Reads FST files with fstapi.
#include <gtkwave/fstapi.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/view/wave/fst.hpp"

namespace rayclock {

namespace {

/// Removes the blank that Verilator leaves before a range.
std::string name_of(std::string name) {
    if (const std::size_t blank = name.find(' '); blank != std::string::npos) name.erase(blank, 1);
    return name;
}

void read_hierarchy(void* reader, const FstVisitor& visitor) {
    fstReaderIterateHierRewind(reader);
    while (const fstHier* entry = fstReaderIterateHier(reader)) {
        if (entry->htyp == FST_HT_SCOPE && visitor.open_scope) visitor.open_scope(entry->u.scope.name);
        if (entry->htyp == FST_HT_UPSCOPE && visitor.close_scope) visitor.close_scope();
        if (entry->htyp == FST_HT_VAR && visitor.signal)
            visitor.signal(entry->u.var.handle, name_of(entry->u.var.name), int(entry->u.var.length),
                           entry->u.var.typ == FST_VT_VCD_PARAMETER);
    }
}

std::string_view view(const unsigned char* value, std::size_t length) {
    return {reinterpret_cast<const char*>(value), length};
}

}   // namespace

void read_fst(const std::string& path, const FstVisitor& visitor) {
    const std::unique_ptr<void, void (*)(void*)> reader(fstReaderOpen(path.c_str()), fstReaderClose);
    if (!reader) throw UserError(printable(path) + ": is not a waveform");
    read_hierarchy(reader.get(), visitor);
    if (!visitor.change) return;
    fstReaderSetFacProcessMaskAll(reader.get());
    const auto text = [](void* user, std::uint64_t time, fstHandle signal, const unsigned char* value,
                         std::uint32_t length) {
        static_cast<const FstVisitor*>(user)->change(time, signal, view(value, length));
    };
    const auto bits = [](void* user, std::uint64_t time, fstHandle signal, const unsigned char* value) {
        static_cast<const FstVisitor*>(user)->change(
            time, signal, reinterpret_cast<const char*>(value));   // terminated by a zero
    };
    fstReaderIterBlocks2(reader.get(), bits, text, const_cast<FstVisitor*>(&visitor), nullptr);
}

}   // namespace rayclock
