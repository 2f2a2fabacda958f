"""What the nodes of a walking session listen to, asked of the master, and a way to talk to it."""
import concurrent.futures
import xmlrpc.client

import rospy

from support import broken_wire, garbage
from walking_session import wait_for

# roscpp's and tf2's own.
FOREIGN = ("/get_loggers", "/set_logger_level", "/tf2_frames")
CALLERS = 6


class Listeners:
    """The topics and services of some nodes, by name; `types` has the types of both."""

    def __init__(self, uri, nodes):
        master = xmlrpc.client.ServerProxy(uri)
        _, _, (_, subscribers, services) = master.getSystemState("/test")
        known = dict(master.getTopicTypes("/test")[2])
        own = {f"/{node}" for node in nodes}
        self.topics = [topic for topic, ears in sorted(subscribers) if own & set(ears)]
        self.types = {topic: known[topic] for topic in self.topics}
        self.places = {}  # URIs of the services
        for service, providers in sorted(services):
            if own & set(providers) and not service.endswith(FOREIGN):
                self.places[service] = master.lookupService("/test", service)[2]
                self.types[service] = broken_wire.service_type(self.places[service], service)
        self.names = [*self.topics, *self.places]
        self._services = {name: garbage.class_of(self.types[name], "srv") for name in self.places}
        # Services that can be called, but not be told anything senseless.
        self.wordless = {name for name in self.places if not self.request_class(name).__slots__}
        self._publishers = {}
        self._pool = concurrent.futures.ThreadPoolExecutor(CALLERS)
        self._calls = []

    def samples(self, act):
        """{type: message} of what others publish on the topics while act() goes on."""
        found = {}
        subscribers = [
            rospy.Subscriber(topic, garbage.class_of(self.types[topic]),
                             lambda message: found.setdefault(message._type, message))
            for topic in self.topics]
        act()
        for subscriber in subscribers:
            subscriber.unregister()
        return found

    def connect(self):
        """Waits until each topic hears us."""
        for topic in self.topics:
            self._publishers[topic] = rospy.Publisher(
                topic, garbage.class_of(self.types[topic]), queue_size=0)
        for topic, publisher in self._publishers.items():
            wait_for(lambda p=publisher: p.get_num_connections() > 0, 20.0, f"ears on {topic}")

    def request_class(self, service):
        return self._services[service]._request_class

    def publish(self, topic, message):
        self._publishers[topic].publish(message)

    def call(self, service, request):
        """Without waiting for the answer; False when too many of them are still to come."""
        self._calls = [call for call in self._calls if not call.done()]
        if len(self._calls) >= CALLERS:
            return False
        self._calls.append(self._pool.submit(self._call, service, request))
        return True

    def _call(self, service, request):
        try:
            rospy.ServiceProxy(service, self._services[service])(request)
        except rospy.ServiceException:
            pass  # an answer as well

    def call_broken(self, service, faults):
        broken_wire.call_broken(self.places[service], service, self._services[service],
                                self.request_class(service)(), faults)

    def unanswered(self, timeout_s):
        """How many calls have no answer after such a time."""
        return len(concurrent.futures.wait(self._calls, timeout_s).not_done)

    def disconnect(self):
        for publisher in self._publishers.values():
            publisher.unregister()
