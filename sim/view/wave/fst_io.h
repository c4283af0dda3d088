/* Replaces the output functions of GTKWave's fstapi.c, which checks no errors itself. Without these a file cut by
   a full disk would look complete, and a mapping beyond the disk's space would end the program (SIGBUS). The program
   and the RTL library that writes waveforms include this file before fstapi.c. */
#ifndef RC_FST_IO_H
#define RC_FST_IO_H

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <time.h>
#include <unistd.h>
#include <zlib.h>

/* The first error since the variable was last set to 0. */
#ifdef __cplusplus
extern "C" {
#endif
int rc_fst_error = 0;
#ifdef __cplusplus
}
#endif

static void rc_fst_note(int failed) {
    if (failed && rc_fst_error == 0) rc_fst_error = errno ? errno : EIO;
}

static size_t rc_fst_fwrite(const void* data, size_t size, size_t count, FILE* file) {
    const size_t written = fwrite(data, size, count, file);
    rc_fst_note(size != 0 && written != count);
    return written;
}
static int rc_fst_fputc(int c, FILE* file) {
    const int result = fputc(c, file);
    rc_fst_note(result == EOF);
    return result;
}
static int rc_fst_fflush(FILE* file) {
    const int result = fflush(file);
    rc_fst_note(result != 0);
    return result;
}
static int rc_fst_fclose(FILE* file) {
    int result;
    rc_fst_note(ferror(file));
    result = fclose(file);
    rc_fst_note(result != 0);
    return result;
}
static int rc_fst_gzwrite(gzFile file, const void* data, unsigned size) {
    const int written = gzwrite(file, data, size);
    rc_fst_note(written != (int)size);
    return written;
}
static int rc_fst_gzclose(gzFile file) {
    const int result = gzclose(file);
    rc_fst_note(result != Z_OK);
    return result;
}
/* Reserves the space on disk before it maps the file. On failure returns anonymous memory that is discarded. */
static void* rc_fst_mmap(void* at, size_t size, int protection, int flags, int file, off_t offset) {
    const int error = protection & PROT_WRITE ? posix_fallocate(file, offset, (off_t)size) : 0;
    if (error == 0) return mmap(at, size, protection, flags, file, offset);
    errno = error;
    rc_fst_note(1);
    return mmap(at, size, protection, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
}

#define fwrite rc_fst_fwrite
#define fputc rc_fst_fputc
#define fflush rc_fst_fflush
#define fclose rc_fst_fclose
#define gzwrite rc_fst_gzwrite
#define gzclose rc_fst_gzclose
#define mmap rc_fst_mmap

#endif
