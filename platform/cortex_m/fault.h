/* fault - the last words of a Cortex-M
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_CORTEX_M_FAULT_H
#define PLT_CORTEX_M_FAULT_H

/* Handler of every fault: prints "FAULT" and the fault registers on one line
 * and ends with MACHINE_FAULT_STATUS. */
void fault_entry(void);

#endif
