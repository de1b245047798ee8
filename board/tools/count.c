/* count - exact instruction counts of a guest: a plug-in for QEMU's TCG
 *
 *   -plugin libcount.so,out=FILE,stack=LOW:HIGH:FROM,region=NAME:BEGIN:END,...
 *
 * Counts every instruction executed, and those between the one at address
 * BEGIN and the one at END, summed over all passes. Watches stores between
 * LOW and HIGH once the instruction at FROM has run: the lowest gives the
 * deepest stack, which checks what the firmware's own paint shows.
 * With code=LOW:HIGH,profile=PATH every instruction there has a counter of its
 * own; PATH gets "ADDRESS COUNT" lines.
 * With mark=ADDRESS,marks=PATH the instruction there ends a chapter, of which PATH gets a line:
 * "chapter total=N NAME=N NAME_passes=N NAME_longest=N ...", of each region its sum, how often it
 * was passed, and the longest pass. What has not come to its END counts where it does.
 * Writes "instructions total=N NAME=N ... NAME_longest=N ... stored_stack=N" to FILE.
 *
 * Debian ships QEMU with plug-ins but without their header, so the calls in
 * use are declared here (QEMU, docs/devel/tcg-plugins, version 1).
 *
 * SPDX-License-Identifier: MIT */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef uint64_t plugin_id;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
typedef void translate_function(plugin_id, struct qemu_plugin_tb *);
typedef void execute_function(unsigned cpu, void *context);
typedef void access_function(unsigned cpu, uint32_t info, uint64_t address, void *context);
typedef void exit_function(plugin_id, void *context);

enum { INLINE_ADD_U64 = 0, NO_REGISTERS = 0, ACCESS_WRITE = 2 };

extern void qemu_plugin_register_vcpu_tb_trans_cb(plugin_id, translate_function *);
extern void qemu_plugin_register_atexit_cb(plugin_id, exit_function *, void *context);
extern size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *);
extern struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *, size_t);
extern uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *);
extern void qemu_plugin_register_vcpu_insn_exec_inline(struct qemu_plugin_insn *, int operation,
                                                       void *counter, uint64_t step);
extern void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn *, execute_function *,
                                                   int registers, void *context);
extern void qemu_plugin_register_vcpu_mem_cb(struct qemu_plugin_insn *, access_function *,
                                             int registers, int access, void *context);
extern _Bool qemu_plugin_mem_is_store(uint32_t info);

#define EXPORTED __attribute__((visibility("default")))
EXPORTED extern int qemu_plugin_version;
EXPORTED int qemu_plugin_install(plugin_id id, const void *info, int count, char **arguments);
EXPORTED int qemu_plugin_version = 1;

enum { REGIONS = 12 };
typedef struct region {
    char name[32];
    uint64_t begin, end;      /* addresses */
    uint64_t entered;         /* instructions in total when begun */
    int is_inside;            /* an END alone ends nothing */
    uint64_t spent;           /* sum of all passes */
    uint64_t before;          /* of those of earlier chapters */
    uint64_t passes, longest; /* of this chapter */
} region;

static region regions[REGIONS];
static int region_count;
static uint64_t total, stack_low, stack_high, stack_from, lowest_store = UINT64_MAX;
static int stack_watched;
static uint64_t code_low, code_high, *executed; /* a counter every two bytes */
static uint64_t mark, total_before;
static FILE *marks;
static char out_path[512], profile_path[512];

static void at_begin(unsigned cpu, void *context) {
    region *r = context;
    (void)cpu;
    r->entered = total;
    r->is_inside = 1;
}

static void at_end(unsigned cpu, void *context) {
    region *r = context;
    (void)cpu;
    if (r->is_inside) {
        const uint64_t pass = total - r->entered;
        r->is_inside = 0;
        r->spent += pass;
        r->passes++;
        r->longest = pass > r->longest ? pass : r->longest;
    }
}

static void at_mark(unsigned cpu, void *context) {
    (void)cpu;
    (void)context;
    fprintf(marks, "chapter total=%" PRIu64, total - total_before);
    total_before = total;
    for (region *r = regions; r < regions + region_count; r++) {
        fprintf(marks, " %s=%" PRIu64 " %s_passes=%" PRIu64 " %s_longest=%" PRIu64, r->name,
                r->spent - r->before, r->name, r->passes, r->name, r->longest);
        r->before = r->spent;
        r->passes = r->longest = 0;
    }
    fprintf(marks, "\n");
}

static void at_stack_from(unsigned cpu, void *context) {
    (void)cpu;
    (void)context;
    stack_watched = 1;
}

/* QEMU 7.2 calls this for loads too, whatever was asked for. */
static void at_store(unsigned cpu, uint32_t info, uint64_t address, void *context) {
    (void)cpu;
    (void)context;
    if (stack_watched && qemu_plugin_mem_is_store(info) && address >= stack_low &&
        address < stack_high && address < lowest_store) {
        lowest_store = address;
    }
}

static void watch_marks(struct qemu_plugin_insn *instruction, uint64_t address) {
    if (stack_high && address == stack_from) {
        qemu_plugin_register_vcpu_insn_exec_cb(instruction, at_stack_from, NO_REGISTERS, NULL);
    }
    if (marks && address == mark) {
        qemu_plugin_register_vcpu_insn_exec_cb(instruction, at_mark, NO_REGISTERS, NULL);
    }
    for (int i = 0; i < region_count; i++) { /* one may end where it or another begins */
        if (address == regions[i].end) {
            qemu_plugin_register_vcpu_insn_exec_cb(instruction, at_end, NO_REGISTERS, &regions[i]);
        }
        if (address == regions[i].begin) {
            qemu_plugin_register_vcpu_insn_exec_cb(instruction, at_begin, NO_REGISTERS,
                                                   &regions[i]);
        }
    }
}

static void translate(plugin_id id, struct qemu_plugin_tb *block) {
    (void)id;
    for (size_t i = 0; i < qemu_plugin_tb_n_insns(block); i++) {
        struct qemu_plugin_insn *instruction = qemu_plugin_tb_get_insn(block, i);
        qemu_plugin_register_vcpu_insn_exec_inline(instruction, INLINE_ADD_U64, &total, 1);
        const uint64_t address = qemu_plugin_insn_vaddr(instruction);
        watch_marks(instruction, address);
        if (executed && address >= code_low && address < code_high) {
            qemu_plugin_register_vcpu_insn_exec_inline(instruction, INLINE_ADD_U64,
                                                       &executed[(address - code_low) / 2], 1);
        }
        if (stack_high) {
            qemu_plugin_register_vcpu_mem_cb(instruction, at_store, NO_REGISTERS, ACCESS_WRITE,
                                             NULL);
        }
    }
}

static void report_profile(void) {
    FILE *out = fopen(profile_path, "w");
    if (!out) {
        perror(profile_path);
        return;
    }
    for (uint64_t at = code_low; at < code_high; at += 2) {
        if (executed[(at - code_low) / 2]) {
            fprintf(out, "%08" PRIx64 " %" PRIu64 "\n", at, executed[(at - code_low) / 2]);
        }
    }
    fclose(out);
}

static void report(plugin_id id, void *context) {
    (void)id;
    (void)context;
    FILE *out = out_path[0] ? fopen(out_path, "w") : stderr;
    if (!out) {
        perror(out_path);
        return;
    }
    fprintf(out, "instructions total=%" PRIu64, total);
    for (int i = 0; i < region_count; i++) {
        fprintf(out, " %s=%" PRIu64, regions[i].name, regions[i].spent);
    }
    for (int i = 0; i < region_count && !marks; i++) {
        fprintf(out, " %s_longest=%" PRIu64, regions[i].name, regions[i].longest);
    }
    if (stack_high) {
        const uint64_t used = lowest_store == UINT64_MAX ? 0 : stack_high - lowest_store;
        fprintf(out, " stored_stack=%" PRIu64, used);
    }
    fprintf(out, "\n");
    if (marks) {
        fclose(marks);
    }
    if (out != stderr) {
        fclose(out);
    }
    if (executed && profile_path[0]) {
        report_profile();
    }
}

/* "region=render:0x120:0x124": Thumb addresses may be odd. */
static int read_region(const char *text) {
    region *r = &regions[region_count];
    if (region_count == REGIONS ||
        sscanf(text, "%31[^:]:%" SCNx64 ":%" SCNx64, r->name, &r->begin, &r->end) != 3) {
        return -1;
    }
    r->begin &= ~UINT64_C(1);
    r->end &= ~UINT64_C(1);
    region_count++;
    return 0;
}

static int read_argument(const char *argument) {
    if (strncmp(argument, "region=", 7) == 0) {
        return read_region(argument + 7);
    }
    if (strncmp(argument, "out=", 4) == 0) {
        snprintf(out_path, sizeof out_path, "%s", argument + 4);
        return 0;
    }
    if (strncmp(argument, "profile=", 8) == 0) {
        snprintf(profile_path, sizeof profile_path, "%s", argument + 8);
        return 0;
    }
    if (strncmp(argument, "code=", 5) == 0) {
        const int read = sscanf(argument + 5, "%" SCNx64 ":%" SCNx64, &code_low, &code_high);
        executed = read == 2 && code_high > code_low
                       ? calloc((size_t)(code_high - code_low) / 2 + 1, sizeof *executed)
                       : NULL;
        return executed ? 0 : -1;
    }
    if (strncmp(argument, "mark=", 5) == 0) {
        const int read = sscanf(argument + 5, "%" SCNx64, &mark);
        mark &= ~UINT64_C(1);
        return read == 1 ? 0 : -1;
    }
    if (strncmp(argument, "marks=", 6) == 0) {
        marks = fopen(argument + 6, "w");
        return marks ? 0 : -1;
    }
    if (strncmp(argument, "stack=", 6) == 0) {
        const int read = sscanf(argument + 6, "%" SCNx64 ":%" SCNx64 ":%" SCNx64, &stack_low,
                                &stack_high, &stack_from);
        stack_from &= ~UINT64_C(1);
        return read == 3 && stack_high > stack_low ? 0 : -1;
    }
    return -1;
}

int qemu_plugin_install(plugin_id id, const void *info, int count, char **arguments) {
    (void)info;
    for (int i = 0; i < count; i++) {
        if (read_argument(arguments[i]) < 0) {
            fprintf(stderr, "count: cannot use '%s'\n", arguments[i]);
            return -1;
        }
    }
    qemu_plugin_register_vcpu_tb_trans_cb(id, translate);
    qemu_plugin_register_atexit_cb(id, report, NULL);
    return 0;
}
