package faultline.scenario.xml;

import faultline.io.Message;
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

    /**
     * Creates an exception for a problem with a file as a whole.
     *
     * @param file the name of the file
     * @param message the problem
     */
    public ScenarioException(String file, Message message) {
        this(List.of(new Problem(file, SourceLocation.NONE, message)));
    }

    /** {@return all problems in the order of the file} */
    public List<Problem> problems() {
        return problems;
    }
}
