package faultline.world;

/**
 * Why the world refuses a command.
 *
 * @param reason the rule that the command breaks
 * @param subject the id, or the number, that the rule is about
 */
public record Refusal(Reason reason, String subject) {

    /** The rules of the world. */
    public enum Reason {
        UNKNOWN_OBSTACLE("there is no obstacle %s"),
        UNKNOWN_SENSOR("the robot has no sensor %s"),
        UNKNOWN_FAULT("%s has no such fault"),
        UNKNOWN_MOTOR_FAULT("the %s motors have no such fault"),
        OVERLAPS_ROBOT("%s cannot be put there: it would overlap the robot"),
        PLATFORM_OVERLAPS("the robot has no room for that platform: it would overlap %s"),
        TOO_MANY_MOVING("at most %s obstacles may move"),
        RESERVED_ID("%s is the name of the enclosing wall"),
        FOREIGN_CONTROLLER("the controller is not part of the program and has no settings here");

        private final String sentence;

        Reason(String sentence) {
            this.sentence = sentence;
        }
    }

    /** Returns the refusal as one English sentence, as reports and the command line print it. */
    public String message() {
        return reason.sentence.formatted(subject);
    }
}
