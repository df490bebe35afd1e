package faultline.gui.dialog;

import faultline.engine.RunFailedException;
import faultline.external.ControllerChoice;
import faultline.external.ControllerJars;
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
record ControllerNames(List<Path> jars, List<String> names, String first, RunFailedException problem) {

    static ControllerNames of(List<Path> jars) {
        try {
            return new ControllerNames(jars, ControllerJars.callWith(jars, ControllerChoice::names), null, null);
        } catch (RunFailedException broken) {
            return new ControllerNames(jars, ControllerChoice.names(), null, broken);
        }
    }

    /**
     * Finds the names with some jars and another one, which replaces those with a controller of the same name, such as
     * an earlier version of itself; if it adds none, the names without it.
     */
    static ControllerNames of(List<Path> jars, Path added) {
        List<String> own = new ArrayList<>(of(List.of(added)).names);
        own.removeAll(ControllerChoice.names());
        List<Path> others = jars.stream()
                .filter(jar -> !jar.equals(added) && Collections.disjoint(of(List.of(jar)).names, own))
                .toList();
        ControllerNames before = of(others);
        ControllerNames after =
                of(Stream.concat(others.stream(), Stream.of(added)).toList());
        return after.names.stream()
                .filter(name -> !before.names.contains(name))
                .findFirst()
                .map(first -> new ControllerNames(after.jars, after.names, first, null))
                .orElseGet(() -> new ControllerNames(before.jars, before.names, null, after.problem));
    }
}
