package faultline.gui.text;

import faultline.world.Refusal;

/** Refusals of commands in the user's language. */
public final class RefusalText {

    private RefusalText() {}

    /** Returns a refusal as one sentence. */
    public static String format(Refusal refusal) {
        String subject = refusal.reason() == Refusal.Reason.UNKNOWN_MOTOR_FAULT
                ? Messages.get("motors." + refusal.subject())
                : refusal.subject();
        String key = key(refusal.reason());
        return refusal.reason() == Refusal.Reason.PLATFORM_OVERLAPS
                ? ContactText.get(key, subject)
                : Messages.get(key, subject);
    }

    private static String key(Refusal.Reason reason) {
        return switch (reason) {
            case UNKNOWN_OBSTACLE -> "refused.obstacle";
            case UNKNOWN_SENSOR -> "refused.sensor";
            case UNKNOWN_FAULT -> "refused.fault";
            case UNKNOWN_MOTOR_FAULT -> "refused.motorFault";
            case OVERLAPS_ROBOT -> "refused.robot";
            case PLATFORM_OVERLAPS -> "refused.platform";
            case TOO_MANY_MOVING -> "refused.moving";
            case SHORT_LOOP -> "refused.loop";
            case RESERVED_ID -> "refused.enclosure";
            case FOREIGN_CONTROLLER -> "refused.controller";
        };
    }
}
