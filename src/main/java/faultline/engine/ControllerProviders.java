package faultline.engine;

import faultline.control.Controller;
import faultline.control.ControllerProvider;
import faultline.control.StateTracker;
import faultline.io.MessageText;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.StreamSupport;

/** The controllers in Java that are on the class path, or in jars that the thread's context class loader adds to it. */
public final class ControllerProviders {

    /** The names of the built-in controllers, which a provider must not have. */
    public static final Set<String> BUILT_IN_NAMES = Set.of("wall-follower", "none", "drive", "extern", "recorded");

    private ControllerProviders() {}

    /**
     * {@return the provider of a name, if there is one}
     *
     * @param name the name of the controller
     * @throws RunFailedException if a provider cannot be loaded
     */
    public static Optional<ControllerProvider> find(String name) {
        return all().stream().filter(provider -> provider.name().equals(name)).findFirst();
    }

    /**
     * {@return the names of all providers, in alphabetical order}
     *
     * @throws RunFailedException if a provider cannot be loaded
     */
    public static List<String> names() {
        return all().stream().map(ControllerProvider::name).sorted().toList();
    }

    /**
     * {@return the jars that the providers were loaded from, by the names of their controllers, in alphabetical order}
     * One that was not loaded from a jar is not among them.
     *
     * @throws RunFailedException if a provider cannot be loaded
     */
    public static SortedMap<String, Path> jars() {
        SortedMap<String, Path> jars = new TreeMap<>();
        for (ControllerProvider provider : all()) {
            CodeSource source = provider.getClass().getProtectionDomain().getCodeSource();
            if (source != null) {
                file(source.getLocation()).ifPresent(jar -> jars.putIfAbsent(provider.name(), jar));
            }
        }
        return jars;
    }

    private static Optional<Path> file(URL location) {
        try {
            return Optional.of(Path.of(location.toURI())).filter(Files::isRegularFile);
        } catch (URISyntaxException | IllegalArgumentException | FileSystemNotFoundException e) {
            return Optional.empty();
        }
    }

    /**
     * {@return a new controller}
     *
     * @param name the name of its provider
     * @param settings for it
     * @throws RunFailedException if there is no such provider, or it fails
     */
    public static Controller create(String name, Map<String, String> settings) {
        return create(
                find(name).orElseThrow(() -> new RunFailedException(RunProblem.NO_CONTROLLER.with(name), null)),
                settings);
    }

    /**
     * {@return a new controller}
     *
     * @param provider makes it
     * @param settings for it
     * @throws RunFailedException if the provider fails
     */
    public static Controller create(ControllerProvider provider, Map<String, String> settings) {
        boolean interrupted = Thread.currentThread().isInterrupted();
        try {
            Controller controller = Objects.requireNonNull(provider.create(settings), "create returned null");
            return new StateTracker(controller, MessageText.name(provider.name()));
        } catch (RuntimeException | Error e) {
            throw new RunFailedException(RunProblem.NOT_CREATED.with(provider.name(), e.toString()), e);
        } finally {
            if (!interrupted) {
                // If the provider has interrupted the thread, the caller must not take that for a cancellation.
                Thread.interrupted();
            }
        }
    }

    private static List<ControllerProvider> all() {
        try {
            List<ControllerProvider> providers = StreamSupport.stream(
                            ServiceLoader.load(ControllerProvider.class).spliterator(), false)
                    .toList();
            requireNames(providers);
            return providers;
        } catch (ServiceConfigurationError | LinkageError e) {
            throw new RunFailedException(RunProblem.NOT_LOADED.with(reason(e)), e);
        }
    }

    /** Returns the message of an error, with the exception of the provider's constructor if that caused it. */
    private static String reason(Error error) {
        return error.getCause() == null
                ? String.valueOf(error.getMessage())
                : error.getMessage() + ": " + error.getCause();
    }

    private static void requireNames(List<ControllerProvider> providers) {
        Map<String, ControllerProvider> byName = new HashMap<>();
        for (ControllerProvider provider : providers) {
            String name = name(provider);
            ControllerProvider other = byName.put(name, provider);
            if (BUILT_IN_NAMES.contains(name)) {
                throw new RunFailedException(RunProblem.BUILT_IN_NAME.with(className(provider), name), null);
            }
            if (other != null) {
                throw new RunFailedException(
                        RunProblem.SAME_NAME.with(className(other), className(provider), name), null);
            }
        }
    }

    private static String name(ControllerProvider provider) {
        String name;
        try {
            name = provider.name();
        } catch (RuntimeException | Error e) {
            throw nameless(provider, e.toString(), e);
        }
        if (name == null || name.isBlank()) {
            throw nameless(provider, name == null ? "name returned null" : "name returned a blank", null);
        }
        return name;
    }

    private static RunFailedException nameless(ControllerProvider provider, String problem, Throwable cause) {
        return new RunFailedException(RunProblem.NAMELESS.with(className(provider), problem), cause);
    }

    private static String className(ControllerProvider provider) {
        return provider.getClass().getName();
    }
}
