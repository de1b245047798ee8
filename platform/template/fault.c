/* fault - of a port: the last words of a CPU that met a fault
 *
 * SPDX-License-Identifier: MIT */
#include "platform/bare/start.h"

void fault_entry(void);

/* Where exceptions lead. The stack may have run out: in assembly, first, the guard goes if it would
 * forbid what follows, and the stack pointer is plt_stack_top again; what the CPU says of the fault
 * is kept in registers. Then the line "FAULT name=value ...", of which pc= says where it was, or
 * near= (fault_near), and status 99. */
__attribute__((used)) void fault_entry(void) {
    fault_item("FAULT near=", fault_near());
    machine_print("\n");
    machine_exit(MACHINE_FAULT_STATUS);
}
