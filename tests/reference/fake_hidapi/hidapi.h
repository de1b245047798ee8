/* hidapi - as much of hidapi's interface as port.c uses, for the fake
 *
 * Names, types and meanings are those of hidapi 0.11 to 0.15 (its manual is
 * libusb.info/hidapi); planelet-hid itself is compiled with the real header,
 * so that port.c is checked against both. SPDX-License-Identifier: MIT */
#ifndef FAKE_HIDAPI_HIDAPI_H
#define FAKE_HIDAPI_HIDAPI_H

#include <stddef.h>
#include <wchar.h>

typedef struct hid_device_ hid_device;

struct hid_device_info {
    char *path;
    unsigned short vendor_id, product_id;
    wchar_t *serial_number;
    unsigned short release_number;
    wchar_t *manufacturer_string, *product_string;
    unsigned short usage_page, usage;
    int interface_number;
    struct hid_device_info *next;
};

int hid_init(void);
int hid_exit(void);
struct hid_device_info *hid_enumerate(unsigned short vendor_id, unsigned short product_id);
void hid_free_enumeration(struct hid_device_info *list);
hid_device *hid_open_path(const char *path);
void hid_close(hid_device *device);
int hid_write(hid_device *device, const unsigned char *data, size_t length);
int hid_send_feature_report(hid_device *device, const unsigned char *data, size_t length);
int hid_read_timeout(hid_device *device, unsigned char *data, size_t length, int milliseconds);
const wchar_t *hid_error(hid_device *device);

#endif
