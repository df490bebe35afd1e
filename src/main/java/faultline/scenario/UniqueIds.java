package faultline.scenario;

import faultline.io.MessageText;
import java.util.Map;

/** Keeps the ids of obstacles, and of sensors, apart. */
final class UniqueIds {

    private UniqueIds() {}

    /**
     * Complains of an id that was there before, and remembers it. Missing or impossible ids have had their complaint
     * already.
     */
    static void check(XmlElement node, String id, Map<String, SourceLocation> seen, Problems complaints) {
        if (!id.equals(node.attributes().get("id"))) {
            return;
        }
        SourceLocation first = seen.putIfAbsent(id, node.location());
        if (first != null) {
            complaints.add(
                    node,
                    "id of <" + node.name() + "> is " + MessageText.quoted(id) + ", which the one in line "
                            + first.line() + " has already, allowed is each id once");
        }
    }
}
