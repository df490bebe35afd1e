package faultline.gui.dialog;

import faultline.engine.RunFailedException;
import faultline.external.ControllerChoice;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/**
 * The names of the controllers that are found with some jars. Finding them runs code of the jars, which may take any
 * time, so this is no work for the event dispatch thread.
 *
 * @param names the names of all controllers; if a jar is broken, only those without jars
 * @param first the first name that an added jar has added, null for none
 * @param problem the reason if a jar is broken, null if none is
 */
record ControllerNames(List<String> names, String first, RunFailedException problem) {

    static ControllerNames of(List<Path> jars) {
        try {
            return new ControllerNames(ControllerChoice.withJars(jars, ControllerChoice::names), null, null);
        } catch (RunFailedException broken) {
            return new ControllerNames(ControllerChoice.names(), null, broken);
        }
    }

    /** Finds the names with some jars and another one; if that adds none, those without it. */
    static ControllerNames of(List<Path> jars, Path added) {
        ControllerNames before = of(jars);
        ControllerNames after = of(with(jars, added));
        return after.names.stream()
                .filter(name -> !before.names.contains(name))
                .findFirst()
                .map(first -> new ControllerNames(after.names, first, null))
                .orElseGet(() -> new ControllerNames(before.names, null, after.problem));
    }

    static List<Path> with(List<Path> jars, Path added) {
        return Stream.concat(jars.stream(), Stream.of(added)).toList();
    }
}
