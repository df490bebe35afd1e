package faultline.external;

import faultline.io.Message;
import java.util.stream.Stream;

/** Thrown if the other side violates the protocol. */
final class ProtocolException extends Exception {

    private static final long serialVersionUID = 1L;

    private final ControllerProblem problem;
    private final transient Object[] details;

    /** Creates an exception, given the values of the problem's placeholders after the other side and the time. */
    ProtocolException(ControllerProblem problem, Object... details) {
        super(sentence(problem, "", "", details).toString().strip());
        this.problem = problem;
        this.details = details;
    }

    /**
     * Creates an exception from the action of the other side, such as "wrote no JSON", and the rest of the sentence
     * with its punctuation, which are not translated.
     */
    ProtocolException(String action, String rest) {
        this(ControllerProblem.OTHER, action, rest);
    }

    /** Returns the sentence about the other side at a time. */
    Message sentence(Object who, Object when) {
        return sentence(problem, who, when, details);
    }

    private static Message sentence(ControllerProblem problem, Object who, Object when, Object... details) {
        return problem.with(
                Stream.concat(Stream.of(who, when), Stream.of(details)).toArray());
    }
}
