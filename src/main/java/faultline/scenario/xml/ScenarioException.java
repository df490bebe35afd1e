package faultline.scenario.xml;

import java.util.List;
import java.util.stream.Collectors;

/** A scenario file that cannot be used. The message holds one line for each problem. */
public final class ScenarioException extends Exception {

    private static final long serialVersionUID = 1L;

    private final transient List<Problem> problems;

    /**
     * Creates an exception for at least one problem.
     *
     * @param problems the problems, in the order of the file
     */
    public ScenarioException(List<Problem> problems) {
        super(problems.stream().map(Problem::toString).collect(Collectors.joining("\n")));
        this.problems = List.copyOf(problems);
    }

    /** {@return all problems in the order of the file} */
    public List<Problem> problems() {
        return problems;
    }
}
