/* c_array - see c_array.h
 *
 * Bytes, because an image is bytes on every machine: words would compile in half the time,
 * but be right in one byte order only. Decimal, because that is a third less text
 * than 0x and no slower (2 MiB of random bytes, gcc 12: 7.0 and 10.6 MB, 2.1 s and 250 MB
 * of memory both).
 *
 * A name is the file's with a "_plt" behind it, so that it is never a keyword, nor
 * something of a library or a compiler ("time", "linux").
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/c_array.h"

#include <ctype.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

enum {
    STEM_BYTES = 28,     /* what is kept of a long name: with it, lines stay short */
    LINE_NUMBERS = 24,   /* of "255," each, behind four blanks */
    COLUMNS = 96,        /* of a comment */
    WORD_COLUMNS = 72,   /* of a word in it: of a longer one the end */
    PACKETS = 4,         /* 2, 4, 8 and 16 rays along the side */
    PACKET_OF_CHOICE = 8 /* or what this build has */
};

typedef struct names {
    char lower[STEM_BYTES + 16];  /* "bunny_plt" */
    char upper[STEM_BYTES + 16];  /* "BUNNY_PLT" */
    char c_name[STEM_BYTES + 16]; /* "bunny.c", for the hint */
} names;

static const char *ending_of(const char *path) {
    const size_t length = strlen(path);
    return length >= 2 ? path + length - 2 : "";
}

int c_array_wanted(const char *path) {
    return strcasecmp(ending_of(path), ".c") == 0 || strcasecmp(ending_of(path), ".h") == 0;
}

int c_array_is(const char *path) {
    static const char begin[] = "/* " C_ARRAY_MARK;
    char got[sizeof begin] = "";
    FILE *file = fopen(path, "rb");
    if (file != NULL) {
        got[fread(got, 1, sizeof begin - 1, file)] = '\0';
        fclose(file);
    }
    return strcmp(got, begin) == 0;
}

/* Letters and digits of ASCII stay, all else between them becomes one underscore. A digit
 * cannot begin a name, and one that begins with an underscore is the compiler's. */
static void choose_names(names *n, const char *path) {
    const char *slash = strrchr(path, '/');
    char stem[STEM_BYTES + 1];
    size_t used = 0;
    for (const char *c = slash == NULL ? path : slash + 1; c < ending_of(path) && used < STEM_BYTES;
         c++) {
        const int kept = isalnum((unsigned char)*c) && (unsigned char)*c < 128;
        if (kept || (used > 0 && stem[used - 1] != '_')) {
            stem[used++] = kept ? *c : '_';
        }
    }
    while (used > 0 && stem[used - 1] == '_') {
        used--;
    }
    stem[used] = '\0';
    const int bare = used > 0 && isalpha((unsigned char)stem[0]);
    snprintf(n->lower, sizeof n->lower, "%s%s%s_plt", bare ? "" : "scene", used && !bare ? "_" : "",
             stem);
    snprintf(n->c_name, sizeof n->c_name, "%s%s.c", used ? "" : "scene", stem);
    for (size_t i = 0; i <= strlen(n->lower); i++) {
        n->upper[i] = (char)toupper((unsigned char)n->lower[i]);
    }
}

/* The end of a word, without what would end the comment or begin another, and in
 * printable ASCII: compilers warn of some other characters. */
static size_t comment_word(char text[WORD_COLUMNS + 1], const char *word, size_t length) {
    const size_t kept = length < WORD_COLUMNS ? length : WORD_COLUMNS;
    word += length - kept;
    for (size_t i = 0; i < kept; i++) {
        const int printable = word[i] >= ' ' && word[i] <= '~';
        const int fence = i > 0 && ((word[i] == '/' && word[i - 1] == '*') ||
                                    (word[i] == '*' && word[i - 1] == '/'));
        text[i] = printable && !fence ? word[i] : '?';
    }
    if (kept < length) {
        memcpy(text, "...", 3);
    }
    text[kept] = '\0';
    return kept;
}

/* Words between blanks, in lines of a comment. */
static void comment(output *o, const char *begin, const char *words, fail *f) {
    size_t column = 0;
    while (*words != '\0') {
        char text[WORD_COLUMNS + 1];
        const size_t length = strcspn(words, " "), shown = comment_word(text, words, length);
        const int fresh = column == 0 || column + 1 + shown > COLUMNS;
        output_print(o, f, "%s%s%s", column > 0 && fresh ? "\n" : "", fresh ? begin : " ", text);
        column = fresh ? strlen(begin) + shown : column + 1 + shown;
        words += length + (words[length] == ' ');
    }
    output_print(o, f, "\n");
}

static size_t arena_bytes(const plt_info *info, unsigned side) {
    const plt_options options = {.packet_side = (uint8_t)side};
    return plt_arena_need(info, 1, &options);
}

static unsigned side_of_choice(void) {
    return PLT_PACKET_SIDE_MAX < PACKET_OF_CHOICE ? PLT_PACKET_SIDE_MAX : PACKET_OF_CHOICE;
}

static void describe(output *o, const plt_info *info, fail *f) {
    char text[400];
    int used = snprintf(text, sizeof text, "%" PRIu32 " triangle%s, %" PRIu32 " bytes. ",
                        info->triangles, info->triangles == 1 ? "" : "s", info->image_bytes);
    used += snprintf(text + used, sizeof text - (size_t)used,
                     "Bytes of arena when it is mapped, %s64-bit pointers (32-bit ones take less):",
                     info->build == PLT_BUILD_DEVICE ? "for the worst tree and " : "for ");
    for (unsigned i = 0; i < PACKETS && (2u << i) <= PLT_PACKET_SIDE_MAX; i++) {
        used += snprintf(text + used, sizeof text - (size_t)used, "%s %zu for packets of %ux%u",
                         i > 0 ? "," : "", arena_bytes(info, 2u << i), 2u << i, 2u << i);
    }
    snprintf(text + used, sizeof text - (size_t)used,
             ". The licence is that of the meshes; planelet adds none.");
    comment(o, " * ", text, f);
}

static void print_head(output *o, const plt_info *info, const char *command, fail *f) {
    output_print(o, f, "/* " C_ARRAY_MARK " %d.%d; do not edit\n *\n", PLT_VERSION_MAJOR,
                 PLT_VERSION_MINOR);
    comment(o, " *     ", command == NULL ? "planelet pack" : command, f);
    output_print(o, f, " *\n");
    describe(o, info, f);
    output_print(o, f, " *\n");
}

static void print_alignment(output *o, const names *n, fail *f) {
    output_print(o, f,
                 "#if defined(__cplusplus) && __cplusplus >= 201103L\n"
                 "#define %s_ALIGNED alignas(%d)\n"
                 "#elif defined(_MSC_VER)\n"
                 "#define %s_ALIGNED __declspec(align(%d))\n"
                 "#elif defined(__STDC_VERSION__) && __STDC_VERSION__ >= 201112L\n"
                 "#define %s_ALIGNED _Alignas(%d)\n"
                 "#else\n"
                 "#define %s_ALIGNED __attribute__((aligned(%d)))\n"
                 "#endif\n\n",
                 n->upper, PLT_ALIGN, n->upper, PLT_ALIGN, n->upper, PLT_ALIGN, n->upper,
                 PLT_ALIGN);
}

static void print_numbers(output *o, const packed *image, fail *f) {
    char line[4 + 4 * LINE_NUMBERS + 2];
    for (size_t at = 0; at < image->size && f->text[0] == '\0'; at += LINE_NUMBERS) {
        int used = snprintf(line, sizeof line, "    ");
        for (size_t i = at; i < image->size && i < at + LINE_NUMBERS; i++) {
            used += snprintf(line + used, sizeof line - (size_t)used, "%u,", image->bytes[i]);
        }
        line[used++] = '\n';
        output_write(o, line, (size_t)used, f);
    }
}

static void write_header(output *o, const names *n, const packed *image, const plt_info *info,
                         fail *f) {
    const unsigned side = side_of_choice();
    output_print(
        o, f,
        " *     plt_source source = %s_SOURCE;\n"
        " *\n"
        " * Every file that includes this gets the data once more: for several, pack with\n"
        " * -o %s and compile that.\n"
        " */\n"
        "#ifndef %s_H\n#define %s_H\n\n",
        n->upper, n->c_name, n->upper, n->upper);
    output_print(o, f,
                 "#define %s_BYTES %" PRIu32
                 "u\n"
                 "#define %s_TRIANGLES %" PRIu32
                 "u\n"
                 "/* Enough for packets of %ux%u, depth first. */\n"
                 "#define %s_ARENA_BYTES %zuu\n"
                 "#define %s_SOURCE \\\n    {%s, %s_BYTES, 0, 0, 0}\n\n",
                 n->upper, image->size, n->upper, info->triangles, side, side, n->upper,
                 arena_bytes(info, side), n->upper, n->lower, n->upper);
    print_alignment(o, n, f);
    output_print(o, f, "%s_ALIGNED static const unsigned char\n    %s[%s_BYTES] = {\n", n->upper,
                 n->lower, n->upper);
    print_numbers(o, image, f);
    output_print(o, f, "};\n\n#undef %s_ALIGNED\n\n#endif\n", n->upper);
}

/* Declared first: in C++ a const without that is the file's own. */
static void write_source(output *o, const names *n, const packed *image, fail *f) {
    output_print(o, f,
                 " *     extern const unsigned char %s[];\n"
                 " *     extern const uint32_t %s_bytes;\n"
                 " *     plt_source source = {.mapped = %s, .bytes = %s_bytes};\n"
                 " *\n"
                 " * In C++ the two declarations stand in extern \"C\" {}.\n"
                 " */\n"
                 "#include <stdint.h>\n\n",
                 n->lower, n->lower, n->lower, n->lower);
    print_alignment(o, n, f);
    output_print(o, f,
                 "#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n"
                 "extern const unsigned char %s[];\n"
                 "extern const uint32_t %s_bytes;\n\n"
                 "const uint32_t %s_bytes = %" PRIu32
                 "u;\n\n"
                 "%s_ALIGNED const unsigned char\n    %s[%" PRIu32 "u] = {\n",
                 n->lower, n->lower, n->lower, image->size, n->upper, n->lower, image->size);
    print_numbers(o, image, f);
    output_print(o, f, "};\n\n#ifdef __cplusplus\n}\n#endif\n");
}

int c_array_write(output *o, const char *path, const packed *image, const char *command, fail *f) {
    const plt_source source = {.mapped = image->bytes, .bytes = image->size};
    plt_info info;
    plt_fault fault;
    names n;
    if (plt_image_info(&source, &info, &fault) != PLT_OK) {
        return fail_set(f, path, "%s; please report this", fault.message);
    }
    choose_names(&n, path);
    print_head(o, &info, command, f);
    if (strcasecmp(ending_of(path), ".h") == 0) {
        write_header(o, &n, image, &info, f);
    } else {
        write_source(o, &n, image, f);
    }
    return f->text[0] == '\0' ? 0 : -1;
}
