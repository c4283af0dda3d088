// One list of ports for each module of rtl/board.
#include "sim/run/rtl/board_ports.hpp"

namespace rayclock {

namespace {

/// The ports of one module.
class Ports {
public:
    using Names = std::initializer_list<const char*>;
    Ports& inputs(Names names) { return add(PortKind::fixed, names); }
    Ports& outputs(Names names) { return add(PortKind::plain, names); }
    Ports& low_inputs(Names names) { return add(PortKind::low_in, names); }
    /// Ports that exist as input and as output.
    Ports& both(Names names) {
        for (const char* name : names) {
            all.push_back({name, PortKind::fixed});
            all.push_back({std::string(name) + "_out", PortKind::plain, "", "", "", "", name});
        }
        return *this;
    }
    Ports& sdram_pins() {
        add(PortKind::low, {"sd_cs", "sd_ras", "sd_cas", "sd_we"});
        return outputs({"sd_cke", "sd_ba", "sd_a", "sd_dqm", "sd_dq_oe"}).both({"sd_dq"});
    }
    Ports& add(PortKind kind, Names names) {
        for (const char* name : names) all.push_back({name, kind});
        return *this;
    }

    std::vector<PortSpec> all;
};

}   // namespace

std::vector<PortSpec> board_ports(const std::string& module) {
    Ports p;
    if (module == "rc_sdram")
        p.sdram_pins()
            .inputs({"align", "req_valid", "req_write", "req_addr", "req_tag", "wr_data", "wr_mask"})
            .outputs(
                {"init_done", "req_ready", "wr_next", "wr_tag", "rd_valid", "rd_last", "rd_tag", "rd_data"});
    if (module == "rc_board_memory")
        p.sdram_pins()
            .inputs({"align", "scan_req_valid", "scan_req_addr", "scan_urgent", "pix_req_valid",
                     "pix_req_addr", "pix_data", "pix_mask", "host_req_valid", "host_req_write",
                     "host_req_addr", "host_wr_data"})
            .outputs({"init_done", "scan_req_ready", "scan_rd_valid", "scan_rd_data", "pix_req_ready",
                      "pix_next", "host_req_ready", "host_next", "host_rd_valid", "host_rd_data"})
            .add(PortKind::in, {"mem_req"})
            .add(PortKind::fires, {"mem_rsp"});
    if (module == "rc_pixel_colour")
        p.inputs({"hit_valid", "hit", "pixel_ready"})
            .outputs({"hit_ready", "pixel_valid", "x", "y", "colour", "empty"});
    if (module == "rc_pixel_writer")
        p.inputs({"base", "width", "flush", "pixel_valid", "pixel_x", "pixel_y", "pixel_colour", "req_ready",
                  "next"})
            .outputs({"empty", "pixel_ready", "req_valid", "req_addr", "data", "mask"});
    if (module == "rc_scan_out")
        p.inputs({"base", "width", "height", "double", "req_ready", "rd_valid", "rd_data"})
            .outputs({"takes", "nears", "underruns", "req_valid", "req_addr", "urgent", "pixel_valid",
                      "pixel_colour", "pixel_de", "pixel_hsync", "pixel_vsync"});
    if (module == "rc_tmds") p.inputs({"de", "data", "control"}).outputs({"symbol"});
    if (module == "rc_video_fifo")
        p.inputs({"pixel_clk"})
            .low_inputs({"pixel_rst"})
            .outputs({"overflow", "underflow"})
            .both({"valid", "data"});
    if (module == "rc_video")
        p.inputs({"pixel_valid", "pixel_colour", "pixel_de", "pixel_hsync", "pixel_vsync", "pixel_clk",
                  "shift_clk"})
            .low_inputs({"pixel_rst", "shift_rst"})
            .outputs({"overflow", "underflow", "tmds"});
    if (module == "rc_uart_rx") p.inputs({"rx"}).outputs({"valid", "data", "fault"});
    if (module == "rc_uart_tx") p.inputs({"valid", "data"}).outputs({"ready", "tx"});
    if (module == "rc_link" || module == "rc_host_link")
        p.inputs({"wb_ack", "wb_err", "host_req_ready", "host_next", "host_rd_valid", "host_rd_data"})
            .outputs({"wb_cyc", "wb_stb", "wb_we", "wb_adr", "host_req_valid", "host_req_write",
                      "host_req_addr", "host_wr_data"})
            .both({"wb_dat"});
    if (module == "rc_link")
        p.inputs({"rx_valid", "rx_data", "tx_ready", "reg_good"})
            .outputs({"rx_ready", "tx_valid", "tx_data", "reg_valid", "reg_write", "reg_addr", "bad"})
            .both({"reg_data"});
    if (module == "rc_host_link")
        p.inputs({"rx", "init_done", "flushed", "armed", "underruns", "cycles"})
            .outputs({"tx", "chip_reset", "arm", "draw_base", "base", "width", "height", "double"});
    if (module == "rc_frame_control")
        p.inputs({"arm", "takes", "running", "done", "pixels_empty", "colour_empty"})
            .outputs({"armed", "flushed", "cycles", "flush"})
            .both({"wb_cyc", "wb_stb", "wb_we", "wb_adr", "wb_dat", "wb_ack", "wb_err"});
    if (module == "rc_board")
        p.sdram_pins()
            .inputs({"rx", "pixel_clk", "shift_clk"})
            .low_inputs({"pixel_rst", "shift_rst"})
            .outputs({"tx", "tmds", "led"});
    return p.all;
}

}   // namespace rayclock
