package faultline.world;

import java.util.Locale;

/**
 * Why the world refuses a command.
 *
 * @param reason the rule that the command breaks
 * @param subject the id, or the number, that the rule is about
 */
public record Refusal(Reason reason, String subject) {

    /** The rules of the world. */
    public enum Reason {
        /** No obstacle has the id. */
        UNKNOWN_OBSTACLE("there is no obstacle %s"),
        /** No sensor of the robot has the id. */
        UNKNOWN_SENSOR("the robot has no sensor %s"),
        /** The sensor has no fault of the kind. */
        UNKNOWN_FAULT("%s has no such fault"),
        /** The motors of the side have no fault of the kind. */
        UNKNOWN_MOTOR_FAULT("the %s motors have no such fault"),
        /** The obstacle would overlap the robot. */
        OVERLAPS_ROBOT("%s cannot be put there: it would overlap the robot"),
        /** The larger platform would overlap an obstacle. */
        PLATFORM_OVERLAPS("the robot has no room for that platform: it would overlap %s"),
        /** No more obstacles may move. */
        TOO_MANY_MOVING("at most %s obstacles may move"),
        /** The obstacle would visit all its waypoints in too little time. */
        SHORT_LOOP("%s would be too fast for its waypoints: it must take " + WaypointPath.MIN_LOOP_TIME
                + " s or more to visit all of them"),
        /** The id is that of the enclosing wall. */
        RESERVED_ID("%s is the name of the enclosing wall"),
        /** A controller that is not part of the program has no settings that can change. */
        FOREIGN_CONTROLLER("the controller is not part of the program and has no settings here");

        private final String sentence;

        Reason(String sentence) {
            this.sentence = sentence;
        }
    }

    /** {@return the refusal as one English sentence, as reports and the command line print it} */
    public String message() {
        return String.format(Locale.ROOT, reason.sentence, subject);
    }
}
