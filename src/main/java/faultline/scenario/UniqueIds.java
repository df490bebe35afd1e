package faultline.scenario;

import java.util.Map;

/** Keeps the ids of obstacles, and of sensors, apart. */
final class UniqueIds {

    private UniqueIds() {
    }

    /** Complains of an id that was there before, and remembers it. Missing or impossible ids have had their complaint already. */
    static void check(Node node, String id, Map<String, Place> seen, Complaints complaints) {
        if (!id.equals(node.attributes().get("id"))) {
            return;
        }
        Place first = seen.putIfAbsent(id, node.place());
        if (first != null) {
            complaints.add(node, "id of <" + node.name() + "> is " + Quoting.quoted(id) + ", which the one in line " + first.line()
                    + " has already, allowed is each id once");
        }
    }
}
