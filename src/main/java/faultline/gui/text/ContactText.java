package faultline.gui.text;

import faultline.world.Collision;
import faultline.world.WorldSpec;

/** Sentences about what the robot touches or would overlap: an obstacle, or the enclosing wall, which has no name. */
public final class ContactText {

    private ContactText() {}

    /**
     * Returns the text of a key with its placeholders replaced, the first one by the id of what is touched. For the
     * enclosing wall, it is the text of {@code KEY.enclosure}.
     */
    public static String get(String key, String id, String... others) {
        String[] values = new String[others.length + 1];
        values[0] = id;
        System.arraycopy(others, 0, values, 1, others.length);
        return Messages.get(id.equals(WorldSpec.ENCLOSURE) ? key + ".enclosure" : key, values);
    }

    /** Returns what a robot touched first, when and where. */
    public static String collision(Collision collision) {
        return get(
                "verdict.collided",
                collision.obstacle(),
                NumberText.format("%.3f", collision.time()),
                NumberText.format("%.3f", collision.point().x()),
                NumberText.format("%.3f", collision.point().y()));
    }
}
