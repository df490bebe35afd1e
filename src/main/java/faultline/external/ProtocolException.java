package faultline.external;

/** Thrown if the other side violates the protocol. */
final class ProtocolException extends Exception {

    private static final long serialVersionUID = 1L;

    private final String action;
    private final String details;

    /**
     * Creates an exception from the action of the other side, such as "wrote no JSON", and the rest of the sentence
     * with its punctuation.
     */
    ProtocolException(String action, String details) {
        super(action + details);
        this.action = action;
        this.details = details;
    }

    /** Returns the sentence about the other side, with a time such as "at tick 17". */
    String sentence(String who, String when) {
        return who + " " + action + " " + when + details;
    }
}
