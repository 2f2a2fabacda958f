"""Connections of TCPROS that break its rules: wrong types, cut and overlong messages, noise.

A publisher that the master knows of, so that nodes come to it by themselves, and a client of
services.
"""
import io
import socket
import socketserver
import struct
import threading
import xmlrpc.client
import xmlrpc.server
from urllib.parse import urlparse

NAME = "/broken_wire"
TIMEOUT_S = 5.0
HEADER_FAULTS = ("wrong md5", "wrong type", "no md5", "cut header", "noise for a header")
MESSAGE_FAULTS = ("cut message", "length too small", "length too large", "overlong array", "noise",
                  "empty message", "right message and noise")


def packed_header(fields):
    """A header of TCPROS."""
    words = [f"{key}={value}".encode() for key, value in fields.items()]
    body = b"".join(struct.pack("<I", len(word)) + word for word in words)
    return struct.pack("<I", len(body)) + body


def read_exactly(connection, size):
    data = b""
    while len(data) < size:
        more = connection.recv(size - len(data))
        if not more:
            raise ConnectionError("closed")
        data += more
    return data


def read_header(connection):
    """The fields of the header that the other side sends."""
    body = read_exactly(connection, struct.unpack("<I", read_exactly(connection, 4))[0])
    fields = {}
    while body:
        size = struct.unpack("<I", body[:4])[0]
        key, _, value = body[4:4 + size].partition(b"=")
        fields[key.decode()] = value.decode()
        body = body[4 + size:]
    return fields


def bytes_of(message):
    buffer = io.BytesIO()
    message.serialize(buffer)
    return buffer.getvalue()


class Faults:
    """Draws what is wrong with a connection, and says it on the wire."""

    def __init__(self, dice):
        self.dice = dice
        self.counts = {}

    def draw(self):
        fault = self.dice.choice(HEADER_FAULTS + MESSAGE_FAULTS)
        self.counts[fault] = self.counts.get(fault, 0) + 1
        return fault

    def noise(self):
        return self.dice.getrandbits(8 * 200).to_bytes(200, "little")

    def header(self, fields, fault):
        """The header's bytes with this fault, if it is one of a header."""
        changed = dict(fields)
        if fault == "wrong md5":
            changed["md5sum"] = "0" * 32
        elif fault == "wrong type":
            changed["type"], changed["md5sum"] = "std_msgs/Nothing", "1" * 32
        elif fault == "no md5":
            changed.pop("md5sum")
        data = packed_header(changed)
        if fault == "cut header":
            return data[:self.dice.randrange(1, len(data))]
        return struct.pack("<I", 180) + self.noise() if fault == "noise for a header" else data

    def body(self, message, fault):
        """The message's bytes with its length before them, with this fault."""
        data = bytes_of(message)
        size = len(data)
        if fault == "cut message":
            data = data[:self.dice.randrange(size)] if size else data
            size += 1
        elif fault == "length too small":
            size //= 2
        elif fault == "length too large":
            size += self.dice.choice((1, 4, 1000, 999999999))
        elif fault == "overlong array":
            place = self.dice.randrange(max(1, size - 3))
            data = data[:place] + struct.pack("<I", 200000) + data[place + 4:]
            size = len(data)
        elif fault == "empty message":
            data, size = b"", 0
        noise = self.noise() if "noise" in fault else b""
        return noise if fault == "noise" else struct.pack("<I", size) + data + noise


class BrokenPublisher:
    """Publishes on one topic after another; what it sends depends on `faults`. A context."""

    def __init__(self, master_uri, faults, message_for):
        self._master = xmlrpc.client.ServerProxy(master_uri)
        self._faults, self._message_for = faults, message_for
        self._heard = threading.Semaphore(0)
        broken = self

        class Connection(socketserver.BaseRequestHandler):
            """A subscriber that came."""

            def handle(self):
                self.request.settimeout(TIMEOUT_S)
                try:
                    broken._serve(self.request)
                except OSError:
                    pass  # it was right to leave
                broken._heard.release()

        self._tcp = socketserver.ThreadingTCPServer(("127.0.0.1", 0), Connection)
        self._tcp.daemon_threads = True
        self._xmlrpc = xmlrpc.server.SimpleXMLRPCServer(("127.0.0.1", 0), logRequests=False)
        self._xmlrpc.register_function(self._request_topic, "requestTopic")
        self._uri = f"http://127.0.0.1:{self._xmlrpc.server_address[1]}/"

    def __enter__(self):
        for server in (self._tcp, self._xmlrpc):
            threading.Thread(target=server.serve_forever, daemon=True).start()
        return self

    def __exit__(self, *_):
        for server in (self._tcp, self._xmlrpc):
            server.shutdown()
            server.server_close()

    def _request_topic(self, *_):
        return 1, "", ["TCPROS", "127.0.0.1", self._tcp.server_address[1]]

    def _serve(self, connection):
        asked = read_header(connection)
        fault = self._faults.draw()
        message = self._message_for(asked["topic"])
        fields = {"callerid": NAME, "topic": asked["topic"], "type": message._type,
                  "md5sum": message._md5sum, "latching": "0",
                  "message_definition": message._full_text}
        connection.sendall(self._faults.header(fields, fault))
        if fault in MESSAGE_FAULTS:
            connection.sendall(self._faults.body(message, fault))

    def publish(self, topic, kind):
        """Lets a subscriber of the topic come and hear; False if none came."""
        self._master.registerPublisher(NAME, topic, kind, self._uri)
        came = self._heard.acquire(timeout=TIMEOUT_S)
        self._master.unregisterPublisher(NAME, topic, self._uri)
        return came


def connect(uri):
    parts = urlparse(uri)
    return socket.create_connection((parts.hostname, parts.port), timeout=TIMEOUT_S)


def service_type(uri, service):
    """The type of a service, by its own words."""
    with connect(uri) as connection:
        connection.sendall(packed_header({"callerid": NAME, "service": service, "md5sum": "*",
                                          "probe": "1"}))
        return read_header(connection)["type"]


def call_broken(uri, service, kind, request, faults):
    """A call of a service, of the class `kind`, with something wrong in it."""
    fault = faults.draw()
    fields = {"callerid": NAME, "service": service, "md5sum": kind._md5sum, "type": kind._type,
              "persistent": "0"}
    try:
        with connect(uri) as connection:
            connection.sendall(faults.header(fields, fault))
            if fault in MESSAGE_FAULTS:
                read_header(connection)
                connection.sendall(faults.body(request, fault))
            connection.shutdown(socket.SHUT_WR)
            connection.settimeout(0.5)
            while connection.recv(65536):
                pass
    except OSError:
        pass  # it was right to hang up, or to wait for the rest
