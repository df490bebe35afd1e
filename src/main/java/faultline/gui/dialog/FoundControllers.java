package faultline.gui.dialog;

import faultline.engine.ControllerProviders;
import faultline.engine.RunFailedException;
import faultline.external.ControllerJars;
import faultline.external.ControllerNames;
import java.nio.file.Path;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.stream.Stream;

/**
 * The controllers in Java that are found with some jars. Finding them runs code of the jars, which may take any time,
 * so this is no work for the event dispatch thread.
 *
 * @param jars the jars
 * @param locations where the controllers are, by their names; if a jar is broken, only those without jars
 * @param first the first name that an added jar has added or replaced, null for none
 * @param problem the reason if a jar is broken, null if none is
 */
record FoundControllers(
        List<Path> jars, SortedMap<String, String> locations, String first, RunFailedException problem) {

    static FoundControllers of(List<Path> jars) {
        try {
            return new FoundControllers(
                    jars, ControllerJars.callWith(jars, ControllerProviders::locations), null, null);
        } catch (RunFailedException broken) {
            return new FoundControllers(jars, ControllerProviders.locations(), null, broken);
        }
    }

    /**
     * Finds the controllers with some jars and another one, which replaces those with a controller of the same name,
     * such as an earlier version of itself; if it adds none, the controllers without it.
     */
    static FoundControllers of(List<Path> jars, Path added) {
        FoundControllers classPath = of(List.of());
        Set<String> own = difference(of(List.of(added)), classPath).keySet();
        List<Path> others = jars.stream()
                .filter(jar -> !jar.equals(added)
                        && Collections.disjoint(
                                difference(of(List.of(jar)), classPath).keySet(), own))
                .toList();
        FoundControllers before = of(others);
        FoundControllers after =
                of(Stream.concat(others.stream(), Stream.of(added)).toList());
        return difference(after, before).keySet().stream()
                .min(String::compareTo)
                .map(first -> new FoundControllers(after.jars, after.locations, first, null))
                .orElseGet(() -> new FoundControllers(before.jars, before.locations, null, after.problem));
    }

    /** Returns the controllers that others lack or have elsewhere, as a jar may have a class of the class path, too. */
    private static Map<String, String> difference(FoundControllers found, FoundControllers others) {
        Map<String, String> difference = new HashMap<>(found.locations);
        difference.entrySet().removeAll(others.locations.entrySet());
        return difference;
    }

    /** Returns the names of these controllers and of the program's own. */
    List<String> names() {
        return ControllerNames.all(locations.keySet());
    }
}
