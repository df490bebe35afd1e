package faultline.campaign.plan;

import faultline.io.DidYouMean;
import faultline.io.Message;
import faultline.io.MessageText;
import faultline.scenario.xml.Problem;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.SourceLocation;
import faultline.scenario.xml.XmlElement;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Changes a scenario's tree of elements. Trees are values: a change makes another tree. */
final class ScenarioTree {

    /** Elements of a scenario that a path may name although the file omits them. */
    private static final List<String> OPTIONAL_ELEMENTS = List.of("controller", "motor", "timeline", "expect");

    /** A number of an element among those with its name, from 1. */
    private static final String NUMBER = "[1-9]\\d{0,5}";

    private ScenarioTree() {}

    /** Thrown if a path does not lead to an element. */
    private static final class UnresolvedPathException extends Exception {
        private static final long serialVersionUID = 1L;

        UnresolvedPathException(String message) {
            super(message);
        }
    }

    /**
     * Sets an attribute. The changed element gets the location in the plan, so that a problem with its value is
     * reported there.
     */
    static XmlElement set(XmlElement root, AttributePath path, String text, String file, SourceLocation location)
            throws ScenarioException {
        try {
            return set(root, path.steps(), path.attribute(), text, location);
        } catch (UnresolvedPathException e) {
            Message message = PlanProblem.NO_SUCH_ATTRIBUTE.with(MessageText.excerpt(path.toString()), e.getMessage());
            throw new ScenarioException(List.of(new Problem(file, location, message)));
        }
    }

    private static XmlElement set(
            XmlElement node, List<AttributePath.PathStep> steps, String attribute, String text, SourceLocation location)
            throws UnresolvedPathException {
        if (steps.isEmpty()) {
            Map<String, String> attributes = new LinkedHashMap<>(node.attributes());
            attributes.put(attribute, text);
            return new XmlElement(node.name(), location, attributes, node.children(), node.text());
        }
        AttributePath.PathStep step = steps.get(0);
        List<AttributePath.PathStep> rest = steps.subList(1, steps.size());
        Optional<XmlElement> child = find(node, step);
        if (child.isEmpty()) {
            return append(node, set(create(node, step, location), rest, attribute, text, location));
        }
        List<XmlElement> children = new ArrayList<>(node.children());
        children.set(children.indexOf(child.get()), set(child.get(), rest, attribute, text, location));
        return new XmlElement(node.name(), node.location(), node.attributes(), children, node.text());
    }

    /** Returns a path in which the elements that a tree has are given by their numbers. */
    static AttributePath numbered(XmlElement root, AttributePath path) {
        List<AttributePath.PathStep> steps = new ArrayList<>();
        Optional<XmlElement> node = Optional.of(root);
        for (AttributePath.PathStep step : path.steps()) {
            Optional<XmlElement> child = node.flatMap(parent -> find(parent, step));
            if (child.isEmpty()) {
                steps.add(step);
            } else {
                int index = node.get().childrenNamed(step.element()).toList().indexOf(child.get());
                steps.add(new AttributePath.PathStep(step.element(), String.valueOf(index + 1)));
            }
            node = child;
        }
        return new AttributePath(steps, path.attribute());
    }

    private static Optional<XmlElement> find(XmlElement node, AttributePath.PathStep step) {
        List<XmlElement> named = node.childrenNamed(step.element()).toList();
        Optional<XmlElement> withId =
                named.stream().filter(child -> step.key().equals(id(child))).findFirst();
        if (withId.isPresent() || !(step.key().isEmpty() || step.key().matches(NUMBER))) {
            return withId;
        }
        int index = step.key().isEmpty() ? 0 : Integer.parseInt(step.key()) - 1;
        return index < named.size() ? Optional.of(named.get(index)) : Optional.empty();
    }

    /** Returns the text that distinguishes an element from others with its name, empty if it has none. */
    private static String id(XmlElement node) {
        return node.attributes().getOrDefault(idAttribute(node.name()), "");
    }

    private static String idAttribute(String element) {
        return element.equals("setting") ? "name" : "id";
    }

    /** Creates a sensor, a setting, or an element that has its defaults if it is missing. */
    private static XmlElement create(XmlElement node, AttributePath.PathStep step, SourceLocation location)
            throws UnresolvedPathException {
        boolean sensor = node.name().equals("robot")
                && step.element().equals("sensor")
                && !step.key().isEmpty();
        boolean setting = node.name().equals("controller")
                && step.element().equals("setting")
                && !(step.key().isEmpty() || step.key().matches(NUMBER));
        boolean named = sensor || setting;
        if (!named && !(OPTIONAL_ELEMENTS.contains(step.element()) && step.key().isEmpty())) {
            throw new UnresolvedPathException("<" + node.name() + "> has no " + step.element()
                    + (step.key().isEmpty() ? "" : "[" + step.key() + "]") + suggestion(node, step));
        }
        Map<String, String> attributes = named ? Map.of(idAttribute(step.element()), step.key()) : Map.of();
        return new XmlElement(step.element(), location, attributes, List.of(), "");
    }

    private static String suggestion(XmlElement node, AttributePath.PathStep step) {
        List<String> ids =
                node.childrenNamed(step.element()).map(ScenarioTree::id).toList();
        return ids.isEmpty()
                ? DidYouMean.hint(
                        step.element(),
                        node.children().stream().map(XmlElement::name).toList())
                : DidYouMean.hint(step.key(), ids);
    }

    private static XmlElement append(XmlElement node, XmlElement child) {
        List<XmlElement> children = new ArrayList<>(node.children());
        children.add(child);
        return new XmlElement(node.name(), node.location(), node.attributes(), children, node.text());
    }

    /** Adds a fault at the end of the timeline; adds the timeline if there is none. */
    static XmlElement addFault(XmlElement root, Map<String, String> attributes, SourceLocation location) {
        XmlElement fault = new XmlElement("fault", location, attributes, List.of(), "");
        Optional<XmlElement> timeline = root.firstChild("timeline");
        if (timeline.isEmpty()) {
            return append(root, new XmlElement("timeline", location, Map.of(), List.of(fault), ""));
        }
        List<XmlElement> children = new ArrayList<>(root.children());
        children.set(children.indexOf(timeline.get()), append(timeline.get(), fault));
        return new XmlElement(root.name(), root.location(), root.attributes(), children, root.text());
    }
}
