package faultline.scenario.xml;

import java.util.List;
import java.util.stream.Collectors;

/** A scenario file that cannot be used. The message holds one line for each complaint. */
public final class ScenarioException extends Exception {

    private static final long serialVersionUID = 1L;

    private final transient List<Problem> problems;

    /**
     * A file with something wrong.
     *
     * @param complaints at least one, in the file's order
     */
    public ScenarioException(List<Problem> complaints) {
        super(complaints.stream().map(Problem::toString).collect(Collectors.joining("\n")));
        this.problems = List.copyOf(complaints);
    }

    /**
     * All that is wrong.
     *
     * @return in the file's order
     */
    public List<Problem> problems() {
        return problems;
    }
}
