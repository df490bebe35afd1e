package faultline.scenario.xml;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * An element of a file, before its content is interpreted.
 *
 * @param name the name, without prefix in our namespace, with its prefix in another one
 * @param location the location of the end of its start tag
 * @param attributes the given values by name, in the order of the file, without defaults
 * @param children the children, in the order of the file
 * @param text all text directly inside it
 */
public record XmlElement(
        String name, SourceLocation location, Map<String, String> attributes, List<XmlElement> children, String text) {

    /**
     * {@return the root element of a file; empty, with a problem, if the file is not well-formed}
     *
     * @param bytes the content of the file
     * @param problems the list to which problems are added
     * @param format the format of the file
     */
    public static Optional<XmlElement> parse(byte[] bytes, Problems problems, XmlFormat format) {
        return new XmlParser(bytes, format).parse(problems);
    }

    /**
     * {@return the children of a name}
     *
     * @param child the name of the children, as {@link #name} gives it
     */
    public Stream<XmlElement> childrenNamed(String child) {
        return children.stream().filter(node -> node.name.equals(child));
    }

    /**
     * {@return the first child of a name}
     *
     * @param child the name of the child, as {@link #name} gives it
     */
    public Optional<XmlElement> firstChild(String child) {
        for (XmlElement node : children) {
            if (node.name.equals(child)) {
                return Optional.of(node);
            }
        }
        return Optional.empty();
    }
}
