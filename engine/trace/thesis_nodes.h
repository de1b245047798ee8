/* thesis_nodes - the operations of format.h on nodes of a resident tree, whatever its leaves are
 *
 * Included once by format_thesis.h or format_vertices.h, behind format_state, whose first member is
 * a plt_treelet_state, and FORMAT_PREFETCH_CHILD(t, link), which asks for what a link leads to.
 *
 * SPDX-License-Identifier: MIT */
#ifdef FORMAT_PREFETCH_CHILD /* else there is nothing to make */

static inline void format_state_init(plt_traversal *t) {
    plt_treelet_state_init(t);
}

static inline int format_root(plt_traversal *t, format_place *place) {
    const plt_tree *tree = &t->scene->thesis;
    place_set_box(place, &t->scene->box);
    place->link = tree->root;
    format_state_init(t);
    return tree->root != PLT_LINK_NONE;
}

static inline int format_enter(plt_traversal *t, const format_place *place) {
    plt_treelet_enter(t, place->link);
    return PLT_OK;
}

/* Over an edge, if the place is one, as every seventh or so is: a jump that is mostly foreseen,
 * where a division and what is counted would be 37 instructions for every node. */
static inline int format_cross(plt_traversal *t, const format_place *place) {
    if (format_is_edge(place)) {
        plt_treelet_enter(t, place->link);
    }
    return PLT_OK;
}

static inline int format_return(plt_traversal *t, const format_place *place) {
    return format_is_leaf(place) ? PLT_OK : format_enter(t, place);
}

/* Both children are asked for before it is known which are hit: a cache line too many costs less
 * than one that is late. */
static inline void format_decode(const plt_traversal *t, const format_place *place,
                                 format_children *c) {
    const plt_node *node = &t->scene->thesis.nodes[plt_link_index(place->link)];
    FORMAT_PREFETCH_CHILD(t, plt_node_link(node, 0));
    FORMAT_PREFETCH_CHILD(t, plt_node_link(node, 1));
    children_decode(c, node, place);
}

static inline void format_child(const format_children *c, unsigned child, format_place *place) {
    children_place(c, child, place);
}

#endif
