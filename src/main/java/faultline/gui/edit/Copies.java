package faultline.gui.edit;

import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.world.Motion;
import faultline.world.Obstacle;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Copies of obstacles beside their originals, with ids of their own. */
public final class Copies {

    private static final Vec BESIDE = new Vec(0.2, -0.2);

    private Copies() {
    }

    /**
     * Copies.
     *
     * @param originals what is copied
     * @param taken the ids that are taken
     * @return one for each original: a little to the right and below, unless none of the originals is there any more
     */
    public static List<Obstacle> of(List<Obstacle> originals, Collection<String> taken) {
        Vec by = originals.stream().map(Obstacle::id).anyMatch(taken::contains) ? BESIDE : Vec.ZERO;
        Set<String> ids = new HashSet<>(taken);
        List<Obstacle> copies = new ArrayList<>();
        for (Obstacle original : originals) {
            String id = FreshIds.like(original.id(), ids);
            ids.add(id);
            copies.add(moved(original, id, by));
        }
        return copies;
    }

    private static Obstacle moved(Obstacle original, String id, Vec by) {
        Vec place = Metres.round(original.pose().position().plus(by));
        return original.named(id).at(new Pose(place.x(), place.y(), original.pose().heading())).moving(original.motion().map(way -> moved(way, by)));
    }

    private static Motion moved(Motion way, Vec by) {
        return new Motion(way.speed(), way.loop(), way.points().stream().map(point -> Metres.round(point.plus(by))).toList());
    }
}
