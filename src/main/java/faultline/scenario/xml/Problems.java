package faultline.scenario.xml;

import faultline.io.Message;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Supplier;

/** Collects the problems of one file, so that they are reported together. */
public final class Problems {

    /** The maximum number of problems that are listed. */
    public static final int MAX_LISTED = 100;

    private final String file;
    private final List<Problem> problems = new ArrayList<>();
    private int omitted;

    /**
     * Creates an empty collection.
     *
     * @param file the name of the file
     */
    public Problems(String file) {
        this.file = file;
    }

    /**
     * Adds a problem with an element.
     *
     * @param node the element
     * @param message the problem
     */
    public void add(XmlElement node, Message message) {
        add(node.location(), message);
    }

    /**
     * Adds a problem at a place of the file.
     *
     * @param place the place
     * @param message the problem
     */
    public void add(SourceLocation place, Message message) {
        add(place, () -> message);
    }

    /**
     * Adds a problem whose message takes time to make, as one with a suggestion does: it is made only if it is listed.
     *
     * @param node the element
     * @param message makes the message
     */
    public void add(XmlElement node, Supplier<Message> message) {
        add(node.location(), message);
    }

    private void add(SourceLocation place, Supplier<Message> message) {
        if (problems.size() == MAX_LISTED) {
            omitted++;
            return;
        }
        Problem problem = new Problem(file, place, message.get());
        if (!problems.contains(problem)) {
            problems.add(problem);
        }
    }

    /** {@return whether no problem was added} */
    public boolean isEmpty() {
        return problems.isEmpty();
    }

    /**
     * Throws the collected problems in the order of the file, if there are any.
     *
     * @throws ScenarioException if there are any
     */
    public void throwIfAny() throws ScenarioException {
        if (!problems.isEmpty()) {
            throw new ScenarioException(sorted());
        }
    }

    private List<Problem> sorted() {
        List<Problem> ordered = new ArrayList<>(problems);
        ordered.sort(Comparator.comparing(Problem::location));
        if (omitted > 0) {
            ordered.add(new Problem(file, SourceLocation.NONE, ProblemKind.MORE.with(omitted)));
        }
        return ordered;
    }
}
