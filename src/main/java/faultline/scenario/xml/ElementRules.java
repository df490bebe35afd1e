package faultline.scenario.xml;

import faultline.io.DidYouMean;
import faultline.io.MessageText;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** What may stand inside an element. */
public final class ElementRules {

    private ElementRules() {}

    /** Complains of text, and of every child that is not among the allowed ones. */
    public static void checkChildren(XmlElement node, Collection<String> allowed, Problems complaints) {
        if (!node.text().isBlank()) {
            complaints.add(
                    node,
                    "<" + node.name() + "> holds the text "
                            + MessageText.quoted(node.text().strip()) + ", allowed is "
                            + (allowed.isEmpty() ? "nothing" : "elements only: " + MessageText.joinNames(allowed)));
        }
        for (XmlElement child : node.children()) {
            if (!allowed.contains(child.name())) {
                complaints.add(
                        child,
                        "<" + node.name() + "> may not hold " + MessageText.oneLine("<" + child.name() + ">")
                                + ", allowed is " + (allowed.isEmpty() ? "nothing" : MessageText.joinNames(allowed))
                                + DidYouMean.hint(child.name(), allowed));
            }
        }
    }

    /** The text of an element that holds nothing else. */
    public static String readText(XmlElement node, Problems complaints) {
        new AttributeReader(node, complaints).reportUnknownAndMissing();
        for (XmlElement child : node.children()) {
            complaints.add(
                    child,
                    "<" + node.name() + "> may not hold " + MessageText.oneLine("<" + child.name() + ">")
                            + ", allowed is text");
        }
        return node.text();
    }

    /** Complains of every second child of a name. */
    public static void checkAtMostOne(XmlElement node, List<String> names, Problems complaints) {
        Set<String> seen = new HashSet<>();
        for (XmlElement child : node.children()) {
            if (names.contains(child.name()) && !seen.add(child.name())) {
                complaints.add(child, "<" + node.name() + "> holds a second <" + child.name() + ">, allowed is one");
            }
        }
    }

    /**
     * Reports an id that is already in use, and adds it to those in use. A missing or invalid id has been reported
     * before.
     */
    static void checkUniqueId(XmlElement node, String id, Map<String, SourceLocation> seen, Problems complaints) {
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
