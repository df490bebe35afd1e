package faultline.campaign.plan;

import faultline.scenario.xml.SourceLocation;
import faultline.scenario.xml.XmlElement;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.TreeMap;

/** An element of a scenario that can be changed, and that finds its children by their names and ids. */
final class ChangedElement {

    /** The children of one name in their order, and by their ids and numbers. */
    private record Siblings(List<ChangedElement> all, Map<String, NavigableMap<Integer, ChangedElement>> byId) {
        Siblings() {
            this(new ArrayList<>(), new HashMap<>());
        }

        void add(ChangedElement child) {
            all.add(child);
            child.number = all.size();
            addId(child);
        }

        void addId(ChangedElement child) {
            byId.computeIfAbsent(child.id(), unseen -> new TreeMap<>()).put(child.number, child);
        }

        void removeId(ChangedElement child) {
            NavigableMap<Integer, ChangedElement> same = byId.get(child.id());
            same.remove(child.number);
            if (same.isEmpty()) {
                byId.remove(child.id());
            }
        }

        /** Returns the first child of an id; null if there is none. */
        ChangedElement first(String id) {
            NavigableMap<Integer, ChangedElement> same = byId.get(id);
            return same == null ? null : same.firstEntry().getValue();
        }
    }

    private final XmlElement original;
    /** Null until an attribute is changed. */
    private Map<String, String> attributes;

    private SourceLocation location;
    /** Null until a child is searched for or added. */
    private List<ChangedElement> children;

    private Map<String, Siblings> byName;
    private ChangedElement parent;
    private int number;

    ChangedElement(XmlElement original) {
        this.original = original;
        this.location = original.location();
    }

    String name() {
        return original.name();
    }

    /** Returns the text that distinguishes it from others with its name, empty if it has none. */
    String id() {
        return attributes().getOrDefault(idAttribute(name()), "");
    }

    /** Returns the name of the attribute that distinguishes an element from others with its name. */
    static String idAttribute(String element) {
        return element.equals("setting") ? "name" : "id";
    }

    /** Returns its number among the children of its parent that have its name, from 1. */
    int number() {
        return number;
    }

    private Map<String, String> attributes() {
        return attributes == null ? original.attributes() : attributes;
    }

    /** Sets an attribute, and the location of the element. */
    void set(String attribute, String text, SourceLocation change) {
        if (attributes == null) {
            attributes = new LinkedHashMap<>(original.attributes());
        }
        location = change;
        if (parent != null && attribute.equals(idAttribute(name()))) {
            Siblings siblings = parent.byName.get(name());
            siblings.removeId(this);
            attributes.put(attribute, text);
            siblings.addId(this);
        } else {
            attributes.put(attribute, text);
        }
    }

    /** Adds a child at the end. */
    ChangedElement append(XmlElement element) {
        open();
        return add(element);
    }

    private ChangedElement add(XmlElement element) {
        ChangedElement child = new ChangedElement(element);
        child.parent = this;
        children.add(child);
        byName.computeIfAbsent(child.name(), unseen -> new Siblings()).add(child);
        return child;
    }

    List<ChangedElement> childrenNamed(String name) {
        open();
        Siblings siblings = byName.get(name);
        return siblings == null ? List.of() : siblings.all;
    }

    /** Returns the names of the children, in their order. */
    List<String> childNames() {
        open();
        return children.stream().map(ChangedElement::name).toList();
    }

    /** Returns the child to which a step of a path leads. */
    Optional<ChangedElement> find(AttributePath.PathStep step) {
        List<ChangedElement> named = childrenNamed(step.element());
        if (named.isEmpty()) {
            return Optional.empty();
        }
        ChangedElement withId = byName.get(step.element()).first(step.key());
        if (withId != null || !(step.key().isEmpty() || step.isNumbered())) {
            return Optional.ofNullable(withId);
        }
        int index = step.key().isEmpty() ? 0 : Integer.parseInt(step.key()) - 1;
        return index < named.size() ? Optional.of(named.get(index)) : Optional.empty();
    }

    private void open() {
        if (children == null) {
            children = new ArrayList<>();
            byName = new HashMap<>();
            original.children().forEach(this::add);
        }
    }

    /** Returns it with all changes; the original elements where nothing is changed. */
    XmlElement toElement() {
        if (attributes == null && children == null) {
            return original;
        }
        List<XmlElement> elements = children == null
                ? original.children()
                : children.stream().map(ChangedElement::toElement).toList();
        return new XmlElement(name(), location, attributes(), elements, original.text());
    }
}
