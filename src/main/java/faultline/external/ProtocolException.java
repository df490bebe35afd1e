package faultline.external;

/** The other side broke the protocol. */
final class ProtocolException extends Exception {

    private static final long serialVersionUID = 1L;

    private final String deed;
    private final String details;

    /**
     * Creates an exception from the parts of a sentence.
     *
     * @param deed what the other side did, such as "wrote no JSON"
     * @param details the rest of the sentence, with its punctuation
     */
    ProtocolException(String deed, String details) {
        super(deed + details);
        this.deed = deed;
        this.details = details;
    }

    /**
     * Returns the sentence.
     *
     * @param who the other side
     * @param when such as "at tick 17"
     */
    String sentence(String who, String when) {
        return who + " " + deed + " " + when + details;
    }
}
