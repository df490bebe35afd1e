package faultline.campaign.plan;

import faultline.io.DidYouMean;
import faultline.io.Message;
import faultline.io.MessageText;
import faultline.scenario.xml.Problem;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.SourceLocation;
import faultline.scenario.xml.XmlElement;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A copy of a scenario's tree of elements that can be changed. Except for the first change of an element's children, a
 * change takes time that hardly depends on the size of the tree.
 */
final class ScenarioTree {

    /** Elements of a scenario that a path may name although the file omits them. */
    private static final List<String> OPTIONAL_ELEMENTS = List.of("controller", "motor", "timeline", "expect");

    private final ChangedElement root;

    ScenarioTree(XmlElement root) {
        this.root = new ChangedElement(root);
    }

    /** Thrown if a path does not lead to an element. */
    private static final class UnresolvedPathException extends Exception {
        private static final long serialVersionUID = 1L;

        UnresolvedPathException(String message) {
            super(message);
        }
    }

    /** Returns the tree with all changes. */
    XmlElement toElement() {
        return root.toElement();
    }

    /**
     * Sets an attribute. The changed element gets the location in the plan, so that a problem with its value is
     * reported there.
     *
     * @throws ScenarioException if the path does not lead to an element; the tree must not be used then
     */
    void set(AttributePath path, String text, String file, SourceLocation location) throws ScenarioException {
        try {
            ChangedElement node = root;
            for (AttributePath.PathStep step : path.steps()) {
                Optional<ChangedElement> child = node.find(step);
                node = child.isPresent() ? child.get() : create(node, step, location);
            }
            node.set(path.attribute(), text, location);
        } catch (UnresolvedPathException e) {
            Message message = PlanProblem.NO_SUCH_ATTRIBUTE.with(MessageText.excerpt(path.toString()), e.getMessage());
            throw new ScenarioException(List.of(new Problem(file, location, message)));
        }
    }

    /** Returns a path in which the elements that the tree has are given by their numbers. */
    AttributePath numbered(AttributePath path) {
        List<AttributePath.PathStep> steps = new ArrayList<>();
        Optional<ChangedElement> node = Optional.of(root);
        for (AttributePath.PathStep step : path.steps()) {
            node = node.flatMap(parent -> parent.find(step));
            steps.add(node.map(child -> new AttributePath.PathStep(step.element(), String.valueOf(child.number())))
                    .orElse(step));
        }
        return new AttributePath(steps, path.attribute());
    }

    /** Returns a note on a path that leads to the first of several elements because it names none of them. */
    Optional<Message> note(AttributePath path) {
        Optional<ChangedElement> node = Optional.of(root);
        for (int i = 0; i < path.steps().size(); i++) {
            AttributePath.PathStep step = path.steps().get(i);
            int count = node.map(parent -> parent.childrenNamed(step.element()).size())
                    .orElse(0);
            node = node.flatMap(parent -> parent.find(step));
            if (step.key().isEmpty() && count > 1) {
                return Optional.of(PlanProblem.FIRST_ONLY.with(
                        MessageText.excerpt(path.toString()),
                        count,
                        step.element(),
                        MessageText.excerpt(path.withKey(i, name(node.get())).toString())));
            }
        }
        return Optional.empty();
    }

    /** Returns the id of an element, or its number if it has none that a path can contain. */
    private static String name(ChangedElement element) {
        return element.id().isEmpty() || element.id().contains("]/") ? String.valueOf(element.number()) : element.id();
    }

    /** Adds a sensor, a setting, or an element that has its defaults if it is missing. */
    private static ChangedElement create(ChangedElement node, AttributePath.PathStep step, SourceLocation location)
            throws UnresolvedPathException {
        boolean sensor = node.name().equals("robot")
                && step.element().equals("sensor")
                && !step.key().isEmpty();
        boolean setting = node.name().equals("controller")
                && step.element().equals("setting")
                && !(step.key().isEmpty() || step.isNumbered());
        boolean named = sensor || setting;
        if (!named && !(OPTIONAL_ELEMENTS.contains(step.element()) && step.key().isEmpty())) {
            throw new UnresolvedPathException("<" + node.name() + "> has no " + step.element()
                    + (step.key().isEmpty() ? "" : "[" + step.key() + "]") + suggestion(node, step));
        }
        Map<String, String> attributes =
                named ? Map.of(ChangedElement.idAttribute(step.element()), step.key()) : Map.of();
        return node.append(new XmlElement(step.element(), location, attributes, List.of(), ""));
    }

    private static String suggestion(ChangedElement node, AttributePath.PathStep step) {
        List<String> ids = node.childrenNamed(step.element()).stream()
                .map(ChangedElement::id)
                .toList();
        return ids.isEmpty() ? DidYouMean.hint(step.element(), node.childNames()) : DidYouMean.hint(step.key(), ids);
    }

    /** Adds a fault at the end of the timeline; adds the timeline if there is none. */
    void addFault(Map<String, String> attributes, SourceLocation location) {
        List<ChangedElement> timelines = root.childrenNamed("timeline");
        ChangedElement timeline = timelines.isEmpty()
                ? root.append(new XmlElement("timeline", location, Map.of(), List.of(), ""))
                : timelines.get(0);
        timeline.append(new XmlElement("fault", location, attributes, List.of(), ""));
    }
}
