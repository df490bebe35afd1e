package faultline.scenario;

import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** What may stand inside an element. */
final class Content {

    private Content() {
    }

    /** Complains of text, and of every child that is not among the allowed ones. */
    static void check(Node node, Collection<String> allowed, Complaints complaints) {
        if (!node.text().isBlank()) {
            complaints.add(node, "<" + node.name() + "> holds the text " + Quoting.quoted(node.text().strip()) + ", allowed is "
                    + (allowed.isEmpty() ? "nothing" : "elements only: " + Quoting.list(allowed)));
        }
        for (Node child : node.children()) {
            if (!allowed.contains(child.name())) {
                complaints.add(child, "<" + node.name() + "> may not hold " + Quoting.oneLine("<" + child.name() + ">") + ", allowed is "
                        + (allowed.isEmpty() ? "nothing" : Quoting.list(allowed)) + Spelling.hint(child.name(), allowed));
            }
        }
    }

    /** The text of an element that holds nothing else. */
    static String text(Node node, Complaints complaints) {
        new Fields(node, complaints).done();
        for (Node child : node.children()) {
            complaints.add(child, "<" + node.name() + "> may not hold " + Quoting.oneLine("<" + child.name() + ">") + ", allowed is text");
        }
        return node.text();
    }

    /** Complains of every second child of a name. */
    static void atMostOne(Node node, List<String> names, Complaints complaints) {
        Set<String> seen = new HashSet<>();
        for (Node child : node.children()) {
            if (names.contains(child.name()) && !seen.add(child.name())) {
                complaints.add(child, "<" + node.name() + "> holds a second <" + child.name() + ">, allowed is one");
            }
        }
    }
}
