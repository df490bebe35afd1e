package faultline.scenario.xml;

import faultline.io.Message;
import faultline.io.MessageText;
import faultline.io.XmlText;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;

/** Checks the content of elements. */
public final class ElementRules {

    private ElementRules() {}

    /**
     * Reports text, for an element that must be empty also white space, and every child that is not among the allowed
     * ones.
     *
     * @param node the element
     * @param allowed the names of the allowed children
     * @param problems the list to which problems are added
     */
    public static void checkChildren(XmlElement node, Collection<String> allowed, Problems problems) {
        String stripped = XmlText.strip(node.text());
        String text = allowed.isEmpty() && stripped.isEmpty() ? node.text() : stripped;
        if (!text.isEmpty()) {
            problems.add(
                    node,
                    ProblemKind.TEXT.with(
                            node.name(),
                            MessageText.excerpt(text),
                            allowed.isEmpty()
                                    ? Allowed.NOTHING.with()
                                    : Allowed.ELEMENTS.with(Allowed.names(allowed))));
        }
        for (XmlElement child : node.children()) {
            if (!allowed.contains(child.name())) {
                reportUnknown(
                        node,
                        child,
                        () -> allowed.isEmpty() ? Allowed.NOTHING.with() : Allowed.names(allowed, child.name()),
                        problems);
            }
        }
    }

    private static void reportUnknown(XmlElement node, XmlElement child, Supplier<Message> allowed, Problems problems) {
        problems.add(
                child,
                () -> ProblemKind.UNKNOWN_ELEMENT.with(node.name(), MessageText.excerpt(child.name()), allowed.get()));
    }

    /**
     * {@return the text of an element that must have neither attributes nor children}
     *
     * @param node the element
     * @param problems the list to which problems are added
     */
    public static String readText(XmlElement node, Problems problems) {
        new AttributeReader(node, problems).reportUnknownAndMissing();
        checkOnlyText(node, problems);
        return node.text();
    }

    /**
     * Reports every child of an element that must contain only text.
     *
     * @param node the element
     * @param problems the list to which problems are added
     */
    public static void checkOnlyText(XmlElement node, Problems problems) {
        for (XmlElement child : node.children()) {
            reportUnknown(node, child, Allowed.TEXT::with, problems);
        }
    }

    /**
     * Reports every child after the first of a name.
     *
     * @param node the element
     * @param names the names of children of which there may be only one each
     * @param problems the list to which problems are added
     */
    public static void checkAtMostOne(XmlElement node, List<String> names, Problems problems) {
        if (node.children().size() < 2) {
            return;
        }
        Set<String> seen = new HashSet<>();
        for (XmlElement child : node.children()) {
            if (names.contains(child.name()) && !seen.add(child.name())) {
                problems.add(child, ProblemKind.DUPLICATE_ELEMENT.with(node.name(), child.name()));
            }
        }
    }

    /**
     * Reports an id that is already in use, and adds it to those in use. A missing or invalid id has been reported
     * before.
     *
     * @param node the element
     * @param id its id
     * @param seen the places of the ids in use
     * @param problems the list to which problems are added
     */
    public static void checkUniqueId(XmlElement node, String id, Map<String, SourceLocation> seen, Problems problems) {
        if (!id.equals(node.attributes().get("id"))) {
            return;
        }
        SourceLocation first = seen.putIfAbsent(id, node.location());
        if (first != null) {
            problems.add(node, ProblemKind.DUPLICATE_ID.with(node.name(), MessageText.excerpt(id), first.line()));
        }
    }
}
