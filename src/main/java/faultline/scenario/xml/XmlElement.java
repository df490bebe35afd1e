package faultline.scenario.xml;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * One element as it stands in a file, before anything is made of it.
 *
 * @param name without prefix in our namespace, with its prefix outside of it
 * @param location where its start tag ends
 * @param attributes as given, by their names, in the file's order; defaults are not among them
 * @param children in the file's order
 * @param text all text directly inside it
 */
public record XmlElement(
        String name, SourceLocation location, Map<String, String> attributes, List<XmlElement> children, String text) {

    /** The children of a name. */
    public Stream<XmlElement> childrenNamed(String child) {
        return children.stream().filter(node -> node.name.equals(child));
    }

    /** The first child of a name. */
    public Optional<XmlElement> firstChild(String child) {
        return childrenNamed(child).findFirst();
    }
}
