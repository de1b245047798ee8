/* parameters - a line of key=value items separated by spaces
 *
 * SPDX-License-Identifier: MIT */
#include "board/parameters.h"

#include "board/number.h"

/* The next item at or after `at`; its length is 0 at the end of the line. */
static parameter next_item(const char *at) {
    while (*at == ' ') {
        at++;
    }
    parameter item = {at, 0};
    while (at[item.length] && at[item.length] != ' ') {
        item.length++;
    }
    return item;
}

static unsigned find_in(const parameter *p, char wanted) {
    unsigned i = 0;
    while (i < p->length && p->text[i] != wanted) {
        i++;
    }
    return i;
}

int parameter_is(const parameter *p, const char *word) {
    unsigned i = 0;
    while (i < p->length && word[i] && p->text[i] == word[i]) {
        i++;
    }
    return i == p->length && !word[i];
}

int parameter_find(const char *line, const char *key, parameter *value) {
    for (parameter item = next_item(line); item.length; item = next_item(item.text + item.length)) {
        const parameter name = {item.text, find_in(&item, '=')};
        if (name.length < item.length && parameter_is(&name, key)) {
            value->text = item.text + name.length + 1;
            value->length = item.length - name.length - 1;
            return 1;
        }
    }
    return 0;
}

static int is_among(const parameter *name, const char *keys) {
    for (parameter key = next_item(keys); key.length; key = next_item(key.text + key.length)) {
        unsigned i = 0;
        while (i < key.length && i < name->length && key.text[i] == name->text[i]) {
            i++;
        }
        if (i == key.length && i == name->length) {
            return 1;
        }
    }
    return 0;
}

int parameter_unknown(const char *line, const char *keys, const char *more, parameter *item) {
    for (*item = next_item(line); item->length; *item = next_item(item->text + item->length)) {
        const parameter name = {item->text, find_in(item, '=')};
        if (name.length == item->length || !(is_among(&name, keys) || is_among(&name, more))) {
            return 1;
        }
    }
    return 0;
}

int parameter_u32(const parameter *p, uint32_t *value) {
    return number_u32(p->text, p->length, value);
}

int parameter_size(const parameter *p, uint32_t *width, uint32_t *height) {
    const unsigned cross = find_in(p, 'x');
    if (cross == p->length || number_u32(p->text, cross, width) < 0) {
        return -1;
    }
    return number_u32(p->text + cross + 1, p->length - cross - 1, height);
}

int parameter_floats(const parameter *p, float *values, unsigned count) {
    parameter rest = *p;
    for (unsigned i = 0; i < count; i++) {
        const unsigned comma = find_in(&rest, ',');
        const int last = i + 1 == count;
        if ((comma == rest.length) != last || number_float(rest.text, comma, &values[i]) < 0) {
            return -1;
        }
        rest.text += comma + !last;
        rest.length -= comma + !last;
    }
    return 0;
}

int parameter_copy(const parameter *p, char *to, size_t bytes) {
    if (p->length == 0 || p->length >= bytes) {
        return -1;
    }
    for (unsigned i = 0; i < p->length; i++) {
        to[i] = p->text[i];
    }
    to[p->length] = '\0';
    return 0;
}
