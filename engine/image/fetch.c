/* fetch - see fetch.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/image/fetch.h"

#include <string.h>

#include "engine/base/fault.h"

#define TAGS 2u

static int failed(plt_fault *fault, uint32_t offset) {
    return plt_fault_set(fault, PLT_ERR_SOURCE, offset, "the source failed to deliver");
}

int plt_fetch(const plt_source *source, uint32_t offset, void *to, uint32_t count,
              plt_fault *fault) {
    unsigned char *at = to;
    if (source->mapped != NULL) {
        memcpy(at, (const unsigned char *)source->mapped + offset, count);
        return PLT_OK;
    }
    int status = PLT_OK;
    uint32_t started = 0;
    for (uint32_t done = 0; done < count && status == PLT_OK; started++) {
        const uint32_t left = count - done;
        const uint32_t now = left < PLT_TRANSFER_BYTES ? left : PLT_TRANSFER_BYTES;
        const unsigned tag = started % TAGS;
        if ((started >= TAGS && source->wait(source->context, 1u << tag) < 0) ||
            source->start(source->context, tag, offset + done, at + done, now) < 0) {
            status = failed(fault, offset + done);
        }
        done += now;
    }
    /* Always: no transfer may still be writing when this returns. */
    const uint32_t tags = started >= TAGS ? (1u << TAGS) - 1 : (1u << started) - 1;
    if (tags != 0 && source->wait(source->context, tags) < 0 && status == PLT_OK) {
        status = failed(fault, offset);
    }
    return status;
}
