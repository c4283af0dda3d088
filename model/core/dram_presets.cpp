// The figures of each memory, with their sources.
#include "model/core/dram_presets.hpp"

namespace rayclock {

// Chips of single data rate state no tRTP. A precharge must not come before the clock of the last data less
// CL - 1, which is burst_length clocks after the read (Micron 256Mb SDRAM, "READ to PRECHARGE").

// Chip: Alliance Memory AS4C32M16SB-7, on ULX3S boards v3.0.7. Other boards carry MT48LC16M16A2 or
// IS42S16160G. Gates: its data sheet, Table 16, column -7.
DramPart sdr() {
    DramPart p;
    p.name = "sdr";
    p.description = "SDR SDRAM of the ULX3S board: AS4C32M16SB-7, 16 bits at 142.9 MHz";
    p.source =
        "AS4C32M16SB-7TCN data sheet, Table 16, "
        "https://manualshelf.com/manual/alliance-memory/as4c32m16sb-7tcn/"
        "datasheet-english/page-21.html; organisation: LiteDRAM litedram/modules.py, class AS4C32M16, "
        "https://github.com/enjoy-digital/litedram; on the board: ULX3S manual, table of production, "
        "https://github.com/emard/ulx3s/blob/master/doc/MANUAL.md; controller: assumed";
    p.bus_bits = 16;   // data sheet: 32M x 16
    p.transfers = 1;
    p.burst_length = 8;   // longest fixed burst; 64 bytes take four
    p.banks = 4;          // LiteDRAM
    p.rows = 8192;        // LiteDRAM
    p.columns = 1024;     // LiteDRAM
    p.tck = 7'000;        // tCK at CL 3, -7
    p.cl = 3;
    p.trcd = 21'000;            // tRCD -7
    p.trp = 21'000;             // tRP -7
    p.tras = 42'000;            // tRAS -7
    p.trc = 63'000;             // tRC -7
    p.trrd = 14'000;            // tRRD -7
    p.tfaw = 0;                 // four banks
    p.trtp = 8 * 7'000;         // the burst, see the top of this file
    p.tccd = 1 * 7'000;         // column commands in any clock (LiteDRAM: 1 clock)
    p.cwl = 0;                  // data come with the command
    p.twr = 14'000;             // tWR -7
    p.twtr = 0;                 // a read may follow in the clock after the last data
    p.trefi = 7'800'000;        // tREFI
    p.trfc = 63'000;            // tRFC -7
    p.request_ps = 2 * 7'000;   // assumed: a register at the queue, one at the pins
    p.answer_ps = 2 * 7'000;    // assumed: a register at the pins, one at the answer
    return p;
}

// The same chip behind a controller that a small FPGA can hold, with logic at half the memory's clock.
// Simulated lone reads of LiteDRAM 2024.12 at half rate (71/143 MHz) take 378 ns from a closed bank and 392
// ns with another row open. Both are 56 ns more than with `sdr`; docs/measured/silicon.md, Memory.
DramPart sdr_half() {
    DramPart p = sdr();
    p.name = "sdr_half";
    p.description =
        "SDR SDRAM of the ULX3S board, behind a controller at half its clock: 16 bits at 142.9 MHz";
    p.source += ", measured: LiteDRAM 2024.12 at half rate under Verilator, docs/measured/silicon.md";
    p.request_ps = 3 * 14'000;   // three clocks of the controller
    p.answer_ps = 3 * 14'000;
    return p;
}

// The same chip behind the controller of rtl/board, which runs at the chip's clock. model/board/sdram.hpp is
// its model; of these figures only the organisation counts.
DramPart board() {
    DramPart p = sdr();
    p.name = "board";
    p.description =
        "SDR SDRAM of the ULX3S board with the board's own controller (rtl/board), screen and pixel writer: "
        "16 bits at the chip's clock";
    return p;
}

// Chip: Micron MT41K128M16JT-125, as Digilent's controller project for the Arty sets it: TimePeriod 3000, CAS
// latency 5, and the gates of its <TimingParameters>. The project states a slower grade (-15E) than that of
// the chip on the board.
DramPart ddr3() {
    DramPart p;
    p.name = "ddr3";
    p.description = "DDR3L of the Digilent Arty A7: MT41K128M16JT-125, 16 bits at 333.3 MHz (DDR3-667)";
    p.source =
        "Digilent board files, old/board_parts/artix7/arty/C.0/mig.prj, "
        "https://github.com/Digilent/vivado-boards; minima "
        "in clocks: Micron 2Gb DDR3 data sheet, Table 56, "
        "http://www.datasheetandpdf.com/EN/MICRON/79/MT41J128M16HA-15ED.htm; controller: assumed";
    p.bus_bits = 16;   // DataWidth
    p.transfers = 2;
    p.burst_length = 8;        // mrBurstLength: 8, fixed
    p.banks = 8;               // BankAddress 3
    p.rows = 16384;            // RowAddress 14
    p.columns = 1024;          // ColAddress 10
    p.tck = 3'000;             // TimePeriod
    p.cl = 5;                  // mrCasLatency
    p.trcd = 13'500;           // trcd
    p.trp = 13'500;            // trp
    p.tras = 36'000;           // tras
    p.trc = 36'000 + 13'500;   // tras + trp: the project states no tRC
    p.trrd = 4 * 3'000;        // the greater of trrd 7.5 ns and 4 clocks (as in LiteDRAM, class MT41J128M16)
    p.tfaw = 45'000;           // tfaw
    p.trtp = 4 * 3'000;        // the greater of trtp 7.5 ns and 4 clocks (Table 56)
    p.tccd = 4 * 3'000;        // 4 clocks (Table 56)
    p.cwl = 5;             // for 2.5 ns <= tCK < 3.3 ns (Micron 2Gb DDR3 data sheet, CWL 5: up to 333 MHz)
    p.twr = 15'000;        // twr
    p.twtr = 4 * 3'000;    // the greater of twtr 7.5 ns and 4 clocks
    p.trefi = 7'800'000;   // trefi
    p.trfc = 160'000;      // trfc
    // Assumed: five clocks of a controller at a quarter of the memory's clock (PHYRatio).
    p.request_ps = 5 * 12'000;
    p.answer_ps = 5 * 12'000;   // assumed: the same on the way back
    return p;
}

// The RPU prototype was one FPGA at 66 MHz (2005). Its memory reportedly gave about 350 MB/s; we found no
// document that names the chips. Assumed: two chips that were common then, and the clock that gives 352 MB/s.
// Gates: Micron 256Mb SDRAM data sheet, Table 12, column -75.
DramPart rpu() {
    DramPart p;
    p.name = "rpu";
    p.description =
        "a memory of the time of the RPU prototype: two MT48LC16M16A2-75, 32 bits at 88 MHz (352 MB/s)";
    p.source =
        "Micron 256Mb SDRAM data sheet, Tables 1 and 12, "
        "https://www.qdatasheet.com/pdf-view/MT48LC64M4A2-Micron?page=27&vm=html; prototype: Woop, "
        "Schmittler, "
        "Slusallek, RPU, SIGGRAPH 2005, https://graphics.cg.uni-saarland.de/2005/woop05rpu/; "
        "chips, bus, clock and controller: assumed, to give about 350 MB/s";
    p.bus_bits = 32;   // assumed: two chips of 16 bits
    p.transfers = 1;
    p.burst_length = 8;          // longest fixed burst; 64 bytes take two
    p.banks = 4;                 // Table 1
    p.rows = 8192;               // Table 1
    p.columns = 512;             // Table 1
    p.tck = 11'364;              // assumed: 88 MHz
    p.cl = 2;                    // tCK(2) of -75 is 10 ns: CL 2 is allowed at this clock
    p.trcd = 20'000;             // tRCD -75
    p.trp = 20'000;              // tRP -75
    p.tras = 44'000;             // tRAS -75
    p.trc = 66'000;              // tRC -75
    p.trrd = 15'000;             // tRRD -75
    p.tfaw = 0;                  // four banks
    p.trtp = 8 * 11'364;         // the burst, see the top of this file
    p.tccd = 1 * 11'364;         // "column address can be changed every clock cycle"
    p.cwl = 0;                   // data come with the command
    p.twr = 15'000;              // tWR -75
    p.twtr = 0;                  // a read may follow in the clock after the last data
    p.trefi = 7'812'500;         // 64 ms / 8192
    p.trfc = 66'000;             // tRFC -75
    p.request_ps = 2 * 11'364;   // assumed, as for sdr
    p.answer_ps = 2 * 11'364;    // assumed, as for sdr
    return p;
}

// Eight chips of 8 bits side by side. DRAMsim3 and gem5 give the gates, in clocks of 0.833 ns or in ns. Where
// they differ (latencies of grade -083 and of 17-17-17), those of 17-17-17 are used.
DramPart ddr4() {
    DramPart p;
    p.name = "ddr4";
    p.description = "a DDR4-2400 module: eight MT40A1G8, 64 bits at 1200 MHz (19.2 GB/s)";
    p.source =
        "Micron MT40A1G8 (8 Gb, x8) as in DRAMsim3 configs/DDR4_8Gb_x8_2400.ini, "
        "https://github.com/umd-memsys/DRAMsim3, and gem5 src/mem/DRAMInterface.py, class DDR4_2400_8x8, "
        "https://github.com/gem5/gem5; controller: assumed, as for ddr3";
    p.bus_bits = 64;
    p.transfers = 2;
    p.burst_length = 8;   // 64 bytes
    p.banks = 16;
    p.bank_groups = 4;
    p.rows = 65536;             // DRAMsim3
    p.columns = 1024;           // DRAMsim3; a row of 1 KB in each chip (gem5)
    p.tck = 833;                // 1200 MHz
    p.cl = 17;                  // gem5: 14.16 ns, 17-17-17
    p.trcd = 14'160;            // gem5
    p.trp = 14'160;             // gem5
    p.tras = 32'000;            // gem5
    p.trc = 32'000 + 14'160;    // tRAS + tRP (DRAMsim3)
    p.trrd = 4 * 833;           // tRRD_S: the greater of 4 clocks and 3.3 ns
    p.trrd_l = 6 * 833;         // tRRD_L: the greater of 4 clocks and 4.9 ns; DRAMsim3: 6 clocks
    p.tfaw = 21'000;            // both
    p.trtp = 7'500;             // gem5: the greater of 4 clocks and 7.5 ns
    p.tccd = 4 * 833;           // tCCD_S (DRAMsim3)
    p.tccd_l = 6 * 833;         // tCCD_L (both)
    p.cwl = 16;                 // DRAMsim3
    p.twr = 19 * 833;           // DRAMsim3
    p.twtr = 9 * 833;           // DRAMsim3: tWTR_L, used for all groups
    p.trefi = 7'800'000;        // both
    p.trfc = 350'000;           // both
    p.request_ps = 5 * 3'332;   // assumed: five clocks of a controller at a quarter of the memory's clock
    p.answer_ps = 5 * 3'332;
    return p;
}

// One channel of 16 bits; packages have two or four of them (dram_channels). Gates in ns: LiteDRAM. Figures
// that LiteDRAM does not state: Ramulator's table after JESD209-4.
DramPart lpddr4() {
    DramPart p;
    p.name = "lpddr4";
    p.description = "a channel of LPDDR4-3200: MT53E256M16D1, 16 bits at 1600 MHz (6.4 GB/s)";
    p.source =
        "Micron MT53E256M16D1 as in LiteDRAM litedram/modules.py, https://github.com/enjoy-digital/litedram; "
        "latency, tRTP and tCCD: Ramulator src/LPDDR4.h, row LPDDR4_3200, after JESD209-4, "
        "https://github.com/CMU-SAFARI/ramulator; controller: assumed, as for ddr3";
    p.bus_bits = 16;
    p.transfers = 2;
    p.burst_length = 16;        // Ramulator: 16n prefetch
    p.banks = 8;                // LiteDRAM
    p.rows = 32768;             // LiteDRAM
    p.columns = 1024;           // LiteDRAM
    p.tck = 625;                // 1600 MHz
    p.cl = 35;                  // Ramulator: nCL 32 and nDQSCK 3
    p.trcd = 18'000;            // LiteDRAM
    p.trp = 21'000;             // LiteDRAM: the value for all banks
    p.tras = 42'000;            // LiteDRAM
    p.trc = 42'000 + 21'000;    // tRAS + tRP
    p.trrd = 10'000;            // LiteDRAM
    p.tfaw = 40'000;            // LiteDRAM
    p.trtp = 14 * 625;          // Ramulator: nRTP 14
    p.tccd = 8 * 625;           // Ramulator: nCCD 8
    p.cwl = 15;                 // JESD209-4: WL 14 of set A, and tDQSS
    p.twr = 18'000;             // JESD209-4
    p.twtr = 10'000;            // JESD209-4
    p.trefi = 3'906'250;        // LiteDRAM: 32 ms / 8192
    p.trfc = 180'000;           // LiteDRAM
    p.request_ps = 5 * 2'500;   // assumed: five clocks of a controller at a quarter of the memory's clock
    p.answer_ps = 5 * 2'500;
    return p;
}

// One channel of 128 bits ("legacy mode"). A stack has eight; dram_channels takes up to four.
DramPart hbm2() {
    DramPart p;
    p.name = "hbm2";
    p.description = "a channel of an HBM2 stack of 2 Gb/s: 128 bits at 1000 MHz (32 GB/s)";
    p.source =
        "DRAMsim3 configs/HBM2_8Gb_x128.ini, https://github.com/umd-memsys/DRAMsim3; rows of 2 KB: gem5 "
        "src/mem/DRAMInterface.py, class HBM_1000_4H_1x128, https://github.com/gem5/gem5; controller: "
        "assumed, as for ddr3";
    p.bus_bits = 128;
    p.transfers = 2;
    p.burst_length = 4;   // 64 bytes
    p.banks = 16;
    p.bank_groups = 4;
    p.rows = 32768;
    p.columns = 128;   // gem5: 2 KB
    p.tck = 1'000;
    p.cl = 14;
    p.trcd = 14'000;   // tRCDRD
    p.trp = 14'000;
    p.tras = 34'000;
    p.trc = 34'000 + 14'000;   // tRAS + tRP
    p.trrd = 4'000;            // tRRD_S
    p.trrd_l = 6'000;          // tRRD_L
    p.tfaw = 30'000;
    p.trtp = 6'000;     // tRTP_L
    p.tccd = 2'000;     // tCCD_S is 1 clock; the burst takes 2
    p.tccd_l = 2'000;   // tCCD_L
    p.cwl = 4;
    p.twr = 16'000;
    p.twtr = 8'000;   // tWTR_L, used for all groups
    p.trefi = 3'900'000;
    p.trfc = 260'000;
    p.request_ps = 5 * 4'000;   // assumed: five clocks of a controller at a quarter of the memory's clock
    p.answer_ps = 5 * 4'000;
    return p;
}

}   // namespace rayclock
