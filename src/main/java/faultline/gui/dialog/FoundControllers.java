package faultline.gui.dialog;

import faultline.engine.RunFailedException;
import faultline.external.ControllerJars;
import faultline.external.ControllerNames;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;

/**
 * The names of the controllers that are found with some jars. Finding them runs code of the jars, which may take any
 * time, so this is no work for the event dispatch thread.
 *
 * @param jars the jars
 * @param names the names of all controllers; if a jar is broken, only those without jars
 * @param first the first name that an added jar has added, null for none
 * @param problem the reason if a jar is broken, null if none is
 */
record FoundControllers(List<Path> jars, List<String> names, String first, RunFailedException problem) {

    static FoundControllers of(List<Path> jars) {
        try {
            return new FoundControllers(jars, ControllerJars.callWith(jars, ControllerNames::all), null, null);
        } catch (RunFailedException broken) {
            return new FoundControllers(jars, ControllerNames.all(), null, broken);
        }
    }

    /**
     * Finds the names with some jars and another one, which replaces those with a controller of the same name, such as
     * an earlier version of itself; if it adds none, the names without it.
     */
    static FoundControllers of(List<Path> jars, Path added) {
        List<String> own = new ArrayList<>(of(List.of(added)).names);
        own.removeAll(ControllerNames.all());
        List<Path> others = jars.stream()
                .filter(jar -> !jar.equals(added) && Collections.disjoint(of(List.of(jar)).names, own))
                .toList();
        FoundControllers before = of(others);
        FoundControllers after =
                of(Stream.concat(others.stream(), Stream.of(added)).toList());
        return after.names.stream()
                .filter(name -> !before.names.contains(name))
                .findFirst()
                .map(first -> new FoundControllers(after.jars, after.names, first, null))
                .orElseGet(() -> new FoundControllers(before.jars, before.names, null, after.problem));
    }
}
